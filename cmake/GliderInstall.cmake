# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# What `cmake --install build --prefix P` writes. All paths in it are relative to each other, so P may be moved.
#   bin/glidercc share/glidercc/         the command and what it reads
#   include/glidercc/                    the headers of missions and behaviours in C (a link)
#   lib/libglider.a                      missions in C, for this computer (those of the boards: share/glidercc/boards/BOARD)
#   lib/cmake/glidercc lib/pkgconfig     find_package(glidercc), toolchains of the boards, pkg-config
#   share/man share/doc/glidercc         manual pages, the documents, examples
# With `--component vehicle`, and only then: the hooks in C99 for who builds a vehicle's software (kit/README.md).

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_SOURCE_DIR}/cmake/package)
set(made ${CMAKE_BINARY_DIR}/package)
set(GLIDER_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/glidercc)
set(GLIDER_DATA_DIR ${CMAKE_INSTALL_DATADIR}/glidercc)
if(NOT CMAKE_INSTALL_DATADIR STREQUAL share OR NOT CMAKE_INSTALL_BINDIR STREQUAL bin)
  message(FATAL_ERROR "glidercc looks for share/glidercc beside its bin/: leave CMAKE_INSTALL_BINDIR and _DATADIR as they are")
endif()

# The command and its data; named one by one, so that nothing else of the build tree slips in.
install(TARGETS glidercc RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(folder boards c debugger explain library platforms scenarios templates)
  install(DIRECTORY ${GLIDER_SHARE_DIR}/${folder} DESTINATION ${GLIDER_DATA_DIR})
endforeach()
if(TARGET glider_ranks)
  install(TARGETS glider_ranks LIBRARY DESTINATION ${GLIDER_DATA_DIR}/mpi)
endif()

# Where a C compiler looks. The one copy of the headers is what `glidercc targets --cflags` names too.
cmake_path(RELATIVE_PATH GLIDER_DATA_DIR BASE_DIRECTORY ${CMAKE_INSTALL_INCLUDEDIR} OUTPUT_VARIABLE data_from_include)
file(MAKE_DIRECTORY ${made})
file(CREATE_LINK ${data_from_include}/c ${made}/glidercc SYMBOLIC)
install(FILES ${made}/glidercc DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${GLIDER_SHARE_DIR}/boards/host/libglider.a DESTINATION ${CMAKE_INSTALL_LIBDIR})

# CMake and pkg-config.
configure_package_config_file(${package}/glidercc-config.cmake.in ${made}/glidercc-config.cmake
  INSTALL_DESTINATION ${GLIDER_CMAKE_DIR} PATH_VARS CMAKE_INSTALL_BINDIR CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR GLIDER_DATA_DIR)
write_basic_package_version_file(${made}/glidercc-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${made}/glidercc-config.cmake ${made}/glidercc-config-version.cmake
  ${package}/glidercc_mission.cmake DESTINATION ${GLIDER_CMAKE_DIR})
cmake_path(RELATIVE_PATH GLIDER_DATA_DIR BASE_DIRECTORY ${GLIDER_CMAKE_DIR} OUTPUT_VARIABLE GLIDER_DATA_FROM_CMAKE)
foreach(GLIDER_BOARD ${GLIDER_BOARDS})
  if(GLIDER_BOARD STREQUAL host)
    continue()
  endif()
  foreach(key triple clang_flags options before after command)
    glider_board_field(${GLIDER_BOARD} ${key} GLIDER_${key})
  endforeach()
  list(JOIN GLIDER_clang_flags " " GLIDER_clang_flags)
  configure_file(${package}/toolchain.cmake.in ${made}/${GLIDER_BOARD}.cmake @ONLY)
  install(FILES ${made}/${GLIDER_BOARD}.cmake DESTINATION ${GLIDER_CMAKE_DIR})
endforeach()
cmake_path(SET up "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
cmake_path(RELATIVE_PATH CMAKE_INSTALL_BINDIR BASE_DIRECTORY ${up} OUTPUT_VARIABLE bin_from_pc)
cmake_path(GET bin_from_pc PARENT_PATH GLIDER_PREFIX_FROM_PC)
configure_file(${package}/glidercc.pc.in ${made}/glidercc.pc @ONLY)
install(FILES ${made}/glidercc.pc DESTINATION ${up})

# To read, and to begin from.
install(FILES ${CMAKE_BINARY_DIR}/share/man/man1/glidercc.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${CMAKE_SOURCE_DIR}/runtime/c/glidercc-runtime.3 DESTINATION ${CMAKE_INSTALL_MANDIR}/man3)
# The documents lie as in the source tree, with what they lead to but source code.
install(FILES LICENSE CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
# The README of who has the package: the command is in the PATH, and there is nothing to build.
set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS README.md)
file(READ ${CMAKE_SOURCE_DIR}/README.md readme)
string(REPLACE "build/bin/glidercc" "glidercc" readme "${readme}")
string(REGEX REPLACE "    scripts/demo +# sets up.*\n\n## A mission"
  "    glidercc new yo first.mission    # a commented mission to begin from\n    glidercc sim first.mission       # flies it and prints the path of its report\n\n## A mission" readme "${readme}")
if(readme MATCHES "\n    scripts/")
  message(FATAL_ERROR "The first commands of README.md have changed: change their copy for the package too.")
endif()
file(WRITE ${made}/README.md "${readme}")
install(FILES ${made}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY missions scenarios DESTINATION ${CMAKE_INSTALL_DOCDIR}
  REGEX "(missions|scenarios|library|templates|gallery|fleet|detector)/CMakeLists[.]txt$" EXCLUDE)
# The examples are built as one.
install(DIRECTORY missions/detector DESTINATION ${CMAKE_INSTALL_DOCDIR}/missions/examples)
install(DIRECTORY support/diagnostics/explain DESTINATION ${CMAKE_INSTALL_DOCDIR}/support/diagnostics)
file(GLOB_RECURSE pages RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS bench/README.md codegen/README.md hooks/README.md ir/README.md kit/README.md
  runtime/README.md simulator/README.md)
file(GLOB vehicle_pages RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS platforms/*.toml)
foreach(page ${pages} ${vehicle_pages})
  cmake_path(GET page PARENT_PATH folder)
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
install(DIRECTORY editors/vscode DESTINATION ${CMAKE_INSTALL_DOCDIR}/editors)

# For the vehicle's own computers: what is C, and all that it includes.
get_property(portable GLOBAL PROPERTY GLIDER_HOOKS_PORTABLE_SOURCES)
list(FILTER portable INCLUDE REGEX "[.]c$")
foreach(source ${portable})
  file(RELATIVE_PATH name ${CMAKE_SOURCE_DIR} ${source})
  cmake_path(GET name PARENT_PATH folder)
  list(APPEND kit_folders ${folder})
  install(FILES ${source} DESTINATION ${folder} COMPONENT vehicle EXCLUDE_FROM_ALL)
endforeach()
list(REMOVE_DUPLICATES kit_folders)
foreach(folder ${kit_folders})
  install(DIRECTORY ${folder}/ DESTINATION ${folder} COMPONENT vehicle EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN *.h PATTERN *.def PATTERN README.md PATTERN model EXCLUDE
    # C++, of the SBC's side
    REGEX "protocol/bounds[.]h$" EXCLUDE PATTERN lockstep.h EXCLUDE PATTERN decimal.h EXCLUDE PATTERN text.h EXCLUDE PATTERN sentence_reader.h EXCLUDE)
endforeach()
install(FILES hooks/transport/byte_stream.h DESTINATION hooks/transport COMPONENT vehicle EXCLUDE_FROM_ALL)
install(FILES ${CMAKE_BINARY_DIR}/generated/platforms/slocum_sensors.h DESTINATION platforms COMPONENT vehicle EXCLUDE_FROM_ALL)
install(FILES tests/kit/vectors.c tests/kit/vectors.def tests/kit/vectors.h tests/kit/hookbeh_vectors.c tests/kit/hookbeh_vectors.def
  DESTINATION tests/kit COMPONENT vehicle EXCLUDE_FROM_ALL)
install(FILES kit/Makefile kit/README.md LICENSE DESTINATION . COMPONENT vehicle EXCLUDE_FROM_ALL)
install(FILES kit/example_behaviour.c kit/example_behaviour.h kit/example_proglet.c kit/example_proglet.h kit/science_bench.c
  DESTINATION kit COMPONENT vehicle EXCLUDE_FROM_ALL)

# `cpack -G DEB` packs what is installed; it builds nothing.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_PACKAGE_VENDOR "The glidercc authors")
set(CPACK_PACKAGE_CONTACT "The glidercc authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "missions for underwater gliders: check, compile, fly")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE zstd)
include(CPack)
