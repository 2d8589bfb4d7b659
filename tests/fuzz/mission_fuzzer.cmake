# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# The target mission_fuzzer with its seeds and dictionary, for scripts/soak/fuzz. Building it takes several minutes of both cores: the
# test suite's share is MissionFuzz, the same promises for random changes of the same seeds.
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
