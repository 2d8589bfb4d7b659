# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

include_guard()
find_program(GLIDERCC_CLANG clang-19)
find_program(GLIDERCC_CLANGXX clang++-19)

# The flags of `glidercc targets --cflags board` as a list.
function(_glidercc_cflags board out)
  get_target_property(command glidercc::glidercc IMPORTED_LOCATION)
  execute_process(COMMAND ${command} targets --cflags ${board} OUTPUT_VARIABLE flags
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  set(${out} ${flags} PARENT_SCOPE)
endfunction()

# glidercc_add_mission(NAME MISSION file [BOARD board] [SOURCES file...] [FLAGS flag...])
# builds NAME-BOARD, the mission's program for a board (`host` if none is named), with what it declares as `extern`
# in C (.c) or C++. The mission's header is written beside the objects, under the name of the mission's file;
# FLAGS are further flags for clang. The target NAME has the property GLIDERCC_PROGRAM, the program's path, and
# GLIDERCC_OBJECTS, what `glidercc sim --link` takes.
function(glidercc_add_mission name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MISSION;BOARD" "SOURCES;FLAGS")
  if(NOT arg_MISSION OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "glidercc_add_mission(NAME MISSION file [BOARD board] [SOURCES file...] [FLAGS flag...])")
  endif()
  if(NOT arg_BOARD)
    set(arg_BOARD host)
  endif()
  if(arg_SOURCES AND NOT (GLIDERCC_CLANG AND GLIDERCC_CLANGXX))
    message(FATAL_ERROR "clang-19 is missing: it compiles C and C++ for the boards (Debian: apt install clang-19 lld-19)")
  endif()
  cmake_path(ABSOLUTE_PATH arg_MISSION BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE mission)
  cmake_path(GET mission STEM stem)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name}.mission)
  file(MAKE_DIRECTORY ${folder})
  set(header ${folder}/${stem}.h)
  add_custom_command(OUTPUT ${header} COMMAND glidercc::glidercc build ${mission} --emit header -o ${header}
    DEPENDS ${mission} VERBATIM)
  _glidercc_cflags(${arg_BOARD} flags)
  set(objects)
  set(links)
  foreach(source ${arg_SOURCES})
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    cmake_path(GET source FILENAME file)
    set(object ${folder}/${file}.o)
    set(compiler ${GLIDERCC_CLANGXX} -std=c++20)
    if(file MATCHES "\\.c$")
      set(compiler ${GLIDERCC_CLANG})
    endif()
    add_custom_command(OUTPUT ${object}
      COMMAND ${compiler} ${flags} -I${folder} ${arg_FLAGS} -MD -MF ${object}.d -MT ${object} -c ${source} -o ${object}
      DEPENDS ${source} ${header} DEPFILE ${object}.d VERBATIM)
    list(APPEND objects ${object})
    list(APPEND links --link ${object})
  endforeach()
  set(program ${CMAKE_CURRENT_BINARY_DIR}/${name}-${arg_BOARD})
  add_custom_command(OUTPUT ${program}
    COMMAND glidercc::glidercc build ${mission} --target ${arg_BOARD} ${links} -o ${program}
    DEPENDS ${mission} ${objects} VERBATIM)
  add_custom_target(${name} ALL DEPENDS ${program})
  set_target_properties(${name} PROPERTIES GLIDERCC_PROGRAM ${program} GLIDERCC_OBJECTS "${objects}")
endfunction()
