# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# Warnings for our own code; generated and third-party code does not link this target.
add_library(glider_warnings INTERFACE)
target_compile_options(glider_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Werror -Wshadow -Wconversion -Wsign-conversion $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor>
  -ffp-contract=off)
# g++ 12's vectoriser drops the rounding of two neighbouring (double)(float)x, which is how a value enters
# the vehicle's float32 sensor array (tests/unit/hooks/values_test.cpp fails without this).
add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
if(GLIDER_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

# glider_library(NAME SOURCES ... [LINKS ...]): one static library of ours, includes from the root.
function(glider_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/generated)
  target_link_libraries(${name} PUBLIC ${arg_LINKS} PRIVATE glider_warnings)
endfunction()

# glider_test(NAME SOURCES ... [LINKS ...]): one GoogleTest program, registered case by case.
function(glider_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  find_package(GTest REQUIRED)
  include(GoogleTest)
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${arg_LINKS} GTest::gtest GTest::gmock GTest::gtest_main
    glider_warnings)
  target_compile_definitions(${name} PRIVATE
    GLIDER_SOURCE_DIR="${CMAKE_SOURCE_DIR}" GLIDER_BINARY_DIR="${CMAKE_BINARY_DIR}")
  # Instrumented code is several times slower.
  set(limit 300)
  if(GLIDER_SANITIZE)
    set(limit 1800)
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT ${limit})
endfunction()
