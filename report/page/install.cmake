# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# Installs the page's packages, unless those of this lockfile are there already: `cmake -DNPM=npm -DPAGE=dir -P install.cmake`.
# npm writes the inner lockfile last, so that a broken-off installation is done again.
set(installed ${PAGE}/node_modules/.package-lock.json)
if(EXISTS ${installed} AND ${installed} IS_NEWER_THAN ${PAGE}/package-lock.json)
  return()
endif()
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
  WORKING_DIRECTORY ${PAGE} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "npm could not install the report page's packages (${result})")
endif()
file(TOUCH ${installed})
