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

# ccache where there is one, unless a launcher is named (an empty one: none).
find_program(CCACHE ccache)
if(CCACHE)
  foreach(language C CXX)
    if(NOT DEFINED CMAKE_${language}_COMPILER_LAUNCHER)
      set(CMAKE_${language}_COMPILER_LAUNCHER ${CCACHE})
    endif()
  endforeach()
endif()
# lld links in a quarter of the time of GNU ld.
option(GLIDER_LLD "Link with lld where there is one" OFF)
find_program(LLD ld.lld PATHS /usr/lib/llvm-19/bin NO_DEFAULT_PATH)
if(GLIDER_LLD AND LLD)
  get_filename_component(folder ${LLD} DIRECTORY)
  add_link_options(-fuse-ld=lld -B${folder})
endif()

# From nothing, the headers cost most of the time: sources of one folder are compiled together, some sixteen at a time. A
# file mostly stays in its group when others come or go. Names in unnamed namespaces must differ within a folder.
option(GLIDER_UNITY "Compile the sources of a folder together (fast from nothing; a change rebuilds more)" ON)
# What runs once a command or a page is optimised less, which it compiles a third faster.
set(GLIDER_RUN_ONCE glider_analysis glider_campaign glider_compiler glider_mission_log glider_report glider_slocum_rules glider_vehicles)
function(glider_unite name)
  if(name IN_LIST GLIDER_RUN_ONCE AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    target_compile_options(${name} PRIVATE -O1)
  endif()
  if(NOT GLIDER_UNITY)
    return()
  endif()
  get_target_property(sources ${name} SOURCES)
  list(FILTER sources INCLUDE REGEX "[.]cpp$")
  foreach(source ${sources})
    get_filename_component(folder ${source} DIRECTORY)
    string(REPLACE ${CMAKE_SOURCE_DIR}/ "" folder "${folder}")
    string(MAKE_C_IDENTIFIER "in_${folder}" folder)
    list(APPEND members_${folder} ${source})
    list(APPEND folders ${folder})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder ${folders})
    list(LENGTH members_${folder} count)
    math(EXPR groups "(${count} + 15) / 16")
    foreach(source ${members_${folder}})
      get_filename_component(file ${source} NAME)
      string(MD5 hash ${file})
      string(SUBSTRING ${hash} 0 6 hash)
      math(EXPR group "0x${hash} % ${groups}")
      set_source_files_properties(${source} TARGET_DIRECTORY ${name} PROPERTIES UNITY_GROUP ${folder}_${group})
    endforeach()
  endforeach()
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A class that a .cpp alone defines may hold what its unnamed namespace does.
  target_compile_options(${name} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
endfunction()

# glider_library(NAME SOURCES ... [LINKS ...]): one static library of ours, includes from the root.
function(glider_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/generated)
  target_link_libraries(${name} PUBLIC ${arg_LINKS} PRIVATE glider_warnings)
  glider_unite(${name})
endfunction()

# glider_test(NAME SOURCES ... [LINKS ...]): one GoogleTest program; each of its suites is a test, NAME.SUITE.
function(glider_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  find_package(GTest REQUIRED)
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${arg_LINKS} GTest::gtest GTest::gmock GTest::gtest_main
    glider_warnings)
  target_compile_definitions(${name} PRIVATE
    GLIDER_SOURCE_DIR="${CMAKE_SOURCE_DIR}" GLIDER_BINARY_DIR="${CMAKE_BINARY_DIR}")
  # What is tested is optimised, what tests it need not be.
  target_compile_options(${name} PRIVATE -O0)
  glider_unite(${name})
  # Instrumented code is several times slower.
  set(limit 600)
  if(GLIDER_SANITIZE)
    set(limit 3600)
  endif()
  set(include ${CMAKE_CURRENT_BINARY_DIR}/${name}.ctest.cmake)
  file(GENERATE OUTPUT ${include} CONTENT "set(glider_program ${name})
set(glider_executable [[$<TARGET_FILE:${name}>]])
set(glider_folder [[${CMAKE_CURRENT_BINARY_DIR}]])
set(glider_limit ${limit})
set(glider_written \${CMAKE_CURRENT_LIST_FILE})
include([[${CMAKE_SOURCE_DIR}/cmake/GliderTestSuites.cmake]])
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
endfunction()
