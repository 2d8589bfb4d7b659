# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# The target mission_fuzzer with its seeds and dictionary, and about a minute of it as a test.
# scripts/soak/fuzz runs it as long as one likes.
set(fuzzing ${CMAKE_BINARY_DIR}/fuzz/mission_fuzzer)
find_program(CLANG_19 clang-19 REQUIRED)
# -w: the warnings are gcc's to give; those of clang about the library's headers are of no use.
add_custom_target(mission_fuzzer
  COMMAND ${CMAKE_COMMAND} -S ${CMAKE_SOURCE_DIR} -B ${fuzzing}/build -G Ninja -DGLIDER_LIBFUZZER=ON -DGLIDER_SANITIZE=ON
    -DCMAKE_C_COMPILER=${CLANG_19} -DCMAKE_CXX_COMPILER=${CLANGXX_19} -DCMAKE_CXX_FLAGS=-w
    -DCMAKE_BUILD_TYPE=RelWithDebInfo "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1"
    -DCMAKE_C_COMPILER_LAUNCHER=${CMAKE_C_COMPILER_LAUNCHER} -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
  COMMAND ${CMAKE_COMMAND} --build ${fuzzing}/build --target mission_fuzzer
  COMMENT "Building mission_fuzzer" VERBATIM)

# Every mission and golden of the project begins the search, and so does every input that once broke something.
file(GLOB_RECURSE seeds CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}
  ${CMAKE_SOURCE_DIR}/missions/*.mission ${CMAKE_SOURCE_DIR}/tests/golden/*.mission)
foreach(seed ${seeds})
  string(REPLACE / _ name ${seed})
  configure_file(${CMAKE_SOURCE_DIR}/${seed} ${fuzzing}/seeds/${name} COPYONLY)
endforeach()

# The words of the grammar and the names of the built-in functions.
file(STRINGS ${CMAKE_SOURCE_DIR}/grammar/GliderLexer.g4 tokens REGEX "^[A-Z_]+ : '[^' ]+'")
file(STRINGS ${CMAKE_SOURCE_DIR}/frontend/sema/names/functions.def functions REGEX "^[A-Z_]+\\([a-z_]+")
set(dictionary)
foreach(line ${tokens} ${functions})
  string(REGEX MATCH "'[^'\\\" ]+'|\\([a-z0-9_]+" word "${line}")
  string(REGEX REPLACE "[('](.+)" "\\1" word "${word}")
  string(REGEX REPLACE "'$" "" word "${word}")
  if(NOT word STREQUAL "")
    string(APPEND dictionary "\"${word}\"\n")
  endif()
endforeach()
file(WRITE ${fuzzing}/words.dict "${dictionary}")

add_test(NAME fuzz.build_mission_fuzzer COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target mission_fuzzer)
set_tests_properties(fuzz.build_mission_fuzzer PROPERTIES FIXTURES_SETUP mission_fuzzer RESOURCE_LOCK build TIMEOUT 1800)
file(MAKE_DIRECTORY ${fuzzing}/short)
add_test(NAME fuzz.mission_fuzzer COMMAND ${fuzzing}/build/bin/mission_fuzzer -seed=1 -runs=4000
  -max_len=4096 -timeout=10 -dict=${fuzzing}/words.dict -artifact_prefix=${fuzzing}/ ${fuzzing}/short ${fuzzing}/seeds)
set_tests_properties(fuzz.mission_fuzzer PROPERTIES FIXTURES_REQUIRED mission_fuzzer TIMEOUT 600)
