# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# Read by ctest when it starts: gives the tests of costs.txt their cost.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/costs.txt rows REGEX "^[0-9]")
foreach(row ${rows})
  string(REGEX MATCH "^([0-9]+) +(.+)$" row "${row}")
  set_tests_properties(${CMAKE_MATCH_2} PROPERTIES COST ${CMAKE_MATCH_1})
endforeach()
