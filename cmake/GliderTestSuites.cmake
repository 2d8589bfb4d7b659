# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# Read by ctest when it starts, once for each GoogleTest program: asks the program for its suites and makes each a test,
# PROGRAM.SUITE, which is one process. What it asked is kept beside the program until that is built again.
# Given: glider_program, glider_executable, glider_folder (where it runs), glider_limit (seconds), glider_written (who gives this).

cmake_minimum_required(VERSION 3.25)

# The label `fast`: suites of these programs, unless they ask a solver or take seconds (tests/costs/costs.txt).
set(glider_fast_programs card_test data_files_test data_tables_test data_traces_test driver_test frontend_test golden_test hooks_posix_test
  hooks_test imc_test janus_test micro_modem_test recon_test ir_test logs_test mission_files_test numbers_test platforms_test report_test runtime_test share_test talker_test simulator_physics_test
  support_test symbols_test)
set(glider_solver_suites golden_test.FixedGoldens golden_test.Prove/Golden)
foreach(suite AnyMomentOf Budget Chattering EndBound Geofences Interruptions Livelocks Nearest ProverStep Requirements Rules Sampling Submersion)
  list(APPEND glider_solver_suites ir_test.${suite})
endforeach()
set(glider_costs ${CMAKE_CURRENT_LIST_DIR}/../tests/costs/costs.txt)
file(STRINGS ${glider_costs} glider_slow_suites REGEX "^[0-9]")
list(TRANSFORM glider_slow_suites REPLACE "^[0-9]+ +" "")

if(NOT EXISTS ${glider_executable})
  add_test(${glider_program}_NOT_BUILT ${glider_program}_NOT_BUILT)
  return()
endif()
set(glider_suites ${glider_executable}.suites.cmake)
if(NOT EXISTS ${glider_suites} OR ${glider_executable} IS_NEWER_THAN ${glider_suites}
   OR ${CMAKE_CURRENT_LIST_FILE} IS_NEWER_THAN ${glider_suites} OR ${glider_written} IS_NEWER_THAN ${glider_suites}
   OR ${glider_costs} IS_NEWER_THAN ${glider_suites})
  execute_process(COMMAND ${glider_executable} --gtest_list_tests
    OUTPUT_VARIABLE listed RESULT_VARIABLE status WORKING_DIRECTORY ${glider_folder})
  # A line of a suite is `Suite.` or `Suite/0.  # TypeParam = int`; those of cases are indented.
  string(REGEX MATCHALL "(^|\n)[A-Za-z_][A-Za-z0-9_/]*\\.( +#[^\n]*)?\n" suites "${listed}")
  if(status OR NOT suites)
    message(FATAL_ERROR "${glider_executable} does not list its tests")
  endif()
  set(script)
  foreach(suite ${suites})
    string(REGEX REPLACE "^\n?([^.]*)\\..*$" "\\1" suite "${suite}")
    set(name ${glider_program}.${suite})
    set(label)
    if(glider_program IN_LIST glider_fast_programs AND NOT name IN_LIST glider_solver_suites AND NOT name IN_LIST glider_slow_suites)
      set(label fast)
    endif()
    # Processes that run at the same time share no temporary files.
    string(REPLACE / _ temporary ${name})
    set(temporary ${glider_folder}/temporary/${temporary})
    file(MAKE_DIRECTORY ${temporary})
    # A suite in which all is skipped is skipped. One in which nothing is found is not passed.
    string(APPEND script "add_test([[${name}]] [[${glider_executable}]] [[--gtest_filter=${suite}.*]])
set_tests_properties([[${name}]] PROPERTIES WORKING_DIRECTORY [[${glider_folder}]] TIMEOUT ${glider_limit}
  ENVIRONMENT [[TEST_TMPDIR=${temporary}]] LABELS [[${label}]]
  SKIP_REGULAR_EXPRESSION [[\\[  PASSED  \\] 0 tests\\.\n(\\[  SKIPPED \\][^\n]*\n)+$]]
  FAIL_REGULAR_EXPRESSION [[\\[==========\\] Running 0 tests]])\n")
  endforeach()
  # At once, for another ctest that starts now.
  string(RANDOM LENGTH 8 mark)
  file(WRITE ${glider_suites}.${mark} "${script}")
  file(RENAME ${glider_suites}.${mark} ${glider_suites})
endif()
include(${glider_suites})
