# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# The boards: what the compiler needs of each at run time, gathered in ${GLIDER_SHARE_DIR}/boards/BOARD:
#   board.toml              platforms/boards/BOARD.toml
#   *.syscalls              the system calls of the board's kernel, if it names a file of them
#   crt1.o, libc.a, ...     the link inputs that board.toml names
#   include/                the headers of the board's C library (not of the host: its own are at hand)
#   NAME.bc                 bitcode made by glider_board_bitcode
# Nothing in these folders names a path of this machine.

# Every board that glidercc builds for.
set(GLIDER_BOARDS host ts7800 ts5500 pizero2 cm4)
set(GLIDER_BOARD_DATA ${CMAKE_CURRENT_LIST_DIR}/../platforms/boards)

# glider_program(VARIABLE NAME): finds one of LLVM's tools.
function(glider_program variable name)
  find_program(${variable} ${name})
  if(NOT ${variable})
    message(FATAL_ERROR "${name} is missing: run scripts/setup")
  endif()
endfunction()
glider_program(GLIDER_CLANG clang-19)
glider_program(GLIDER_CLANGXX clang++-19)
glider_program(GLIDER_LLVM_LINK llvm-link-19)
glider_program(GLIDER_LLVM_CONFIG llvm-config-19)

# glider_sysroot(BOARD OUT): the board's folder in the cache that scripts/setup fills.
function(glider_sysroot board out)
  execute_process(COMMAND ${CMAKE_SOURCE_DIR}/scripts/build_sysroots --print-path
    OUTPUT_VARIABLE sysroots OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  if(NOT EXISTS ${sysroots}/${board}/lib/libc.a)
    message(FATAL_ERROR "the C library of board ${board} is missing in ${sysroots}: "
      "run scripts/setup")
  endif()
  set(${out} ${sysroots}/${board} PARENT_SCOPE)
endfunction()

# glider_board_field(BOARD KEY OUT): the string, or the list of strings, that the board's TOML gives KEY.
function(glider_board_field board key out)
  set(file ${GLIDER_BOARD_DATA}/${board}.toml)
  file(READ ${file} text)
  if(NOT text MATCHES "\n${key} = (\"[^\"\n]*\"|\\[[^]]*\\])")
    message(FATAL_ERROR "${file} has no '${key} = '")
  endif()
  string(REGEX MATCHALL "\"[^\"]*\"" values "${CMAKE_MATCH_1}")
  string(REPLACE "\"" "" values "${values}")
  set(${out} ${values} PARENT_SCOPE)
endfunction()

# glider_host_file(NAME OUT): where this machine's C compiler has the link input NAME.
function(glider_host_file name out)
  execute_process(COMMAND ${CMAKE_C_COMPILER} -print-file-name=${name}
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  if(NOT EXISTS ${found})
    message(FATAL_ERROR "the C compiler has no ${name}: run scripts/setup")
  endif()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# glider_copy(FROM TO): at configure time; follows links, and configures again when FROM changes.
function(glider_copy from to)
  file(REAL_PATH ${from} real)
  configure_file(${real} ${to} COPYONLY)
endfunction()

# glider_board_folder(BOARD): fills the board's folder with all but bitcode.
function(glider_board_folder board)
  set(folder ${GLIDER_SHARE_DIR}/boards/${board})
  glider_copy(${GLIDER_BOARD_DATA}/${board}.toml ${folder}/board.toml)
  glider_board_field(${board} before before)
  glider_board_field(${board} after after)
  foreach(input ${before} ${after})
    if(board STREQUAL host)
      glider_host_file(${input} file)
    else()
      glider_sysroot(${board} sysroot)
      set(file ${sysroot}/lib/${input})
    endif()
    glider_copy(${file} ${folder}/${input})
  endforeach()
  if(NOT board STREQUAL host)
    glider_board_field(${board} system_calls system_calls)
    glider_copy(${GLIDER_BOARD_DATA}/${system_calls} ${folder}/${system_calls})
    # For a scientist's own C: what the board's C library declares.
    file(COPY ${sysroot}/include DESTINATION ${folder})
  endif()
endfunction()

foreach(board ${GLIDER_BOARDS})
  glider_board_folder(${board})
endforeach()

# glider_board_flags(BOARD OUT_C OUT_CXX): how clang compiles onboard C and C++ for the board. The
# project's own flags (sanitizers above all) have no part in it. Boards see their C library's headers
# and those of libc++, of which nothing is linked; the host sees its own.
function(glider_board_flags board out_c out_cxx)
  glider_board_field(${board} triple triple)
  glider_board_field(${board} clang_flags machine)
  set(common --target=${triple} ${machine} -D_DEFAULT_SOURCE -O2 -gline-tables-only -ffp-contract=off -fno-math-errno
    -ffunction-sections -fdata-sections -fno-stack-protector
    -fno-unwind-tables -fno-asynchronous-unwind-tables
    -fdebug-compilation-dir=.
    -ffile-prefix-map=${CMAKE_BINARY_DIR}/= -ffile-prefix-map=${CMAKE_SOURCE_DIR}/=
    -Wall -Wextra -Wpedantic -Werror -Wshadow -Wconversion -Wsign-conversion
    -I${CMAKE_SOURCE_DIR} -I${CMAKE_BINARY_DIR}/generated)
  set(cxx -std=c++20 -fno-exceptions -fno-rtti -fno-threadsafe-statics)
  if(NOT board STREQUAL host)
    glider_sysroot(${board} sysroot)
    execute_process(COMMAND ${GLIDER_CLANG} -print-resource-dir
      OUTPUT_VARIABLE resources OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${GLIDER_LLVM_CONFIG} --prefix
      OUTPUT_VARIABLE llvm_prefix OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    set(libc -ffile-prefix-map=${sysroot}/= -nostdinc -isystem ${sysroot}/include -isystem ${resources}/include)
    list(APPEND cxx -nostdinc++ -D_LIBCPP_HAS_MUSL_LIBC -isystem ${llvm_prefix}/include/c++/v1)
  endif()
  set(${out_c} ${common} -std=c11 ${libc} PARENT_SCOPE)
  set(${out_cxx} ${common} ${cxx} ${libc} PARENT_SCOPE)
endfunction()

# glider_board_bitcode(TARGET BOARD board SOURCES file... [OUTPUT name] [FLAGS flag...] [DEPENDS target...])
# compiles C and C++ sources for a board and links them into one module, boards/BOARD/OUTPUT of the
# shared data (OUTPUT is runtime.bc unless given; it may be an absolute path). TARGET builds it and is part of `all`; DEPENDS names
# targets that must be built before, such as generated headers. What a source includes is tracked.
function(glider_board_bitcode target)
  cmake_parse_arguments(arg "" "BOARD;OUTPUT" "SOURCES;FLAGS;DEPENDS" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES OR NOT arg_BOARD IN_LIST GLIDER_BOARDS)
    message(FATAL_ERROR "glider_board_bitcode(${target}): wrong arguments")
  endif()
  if(NOT arg_OUTPUT)
    set(arg_OUTPUT runtime.bc)
  endif()
  glider_board_flags(${arg_BOARD} c_flags cxx_flags)
  set(modules)
  foreach(source ${arg_SOURCES})
    file(REAL_PATH ${source} source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    file(RELATIVE_PATH name ${CMAKE_SOURCE_DIR} ${source})
    set(module ${CMAKE_BINARY_DIR}/bitcode/${arg_BOARD}/${target}/${name}.bc)
    if(source MATCHES "\\.c$")
      set(compile ${GLIDER_CLANG} ${c_flags})
    else()
      set(compile ${GLIDER_CLANGXX} ${cxx_flags})
    endif()
    get_filename_component(folder ${module} DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${module}
      COMMAND ${compile} ${arg_FLAGS} -MD -MF ${module}.d -MT ${module}
        -emit-llvm -c ${source} -o ${module}
      DEPENDS ${source} ${arg_DEPENDS} DEPFILE ${module}.d
      COMMENT "Compiling ${name} for ${arg_BOARD}" VERBATIM COMMAND_EXPAND_LISTS)
    list(APPEND modules ${module})
  endforeach()
  cmake_path(ABSOLUTE_PATH arg_OUTPUT BASE_DIRECTORY ${GLIDER_SHARE_DIR}/boards/${arg_BOARD}
    OUTPUT_VARIABLE linked)
  add_custom_command(OUTPUT ${linked}
    COMMAND ${GLIDER_LLVM_LINK} ${modules} -o ${linked}
    DEPENDS ${modules} COMMENT "Linking ${arg_OUTPUT} for ${arg_BOARD}" VERBATIM)
  add_custom_target(${target} ALL DEPENDS ${linked})
endfunction()
