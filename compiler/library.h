// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "platforms/load/platform.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace glider::compiler {

/// A file of the standard library.
struct LibraryFile {
  std::filesystem::path path;
  bool routes_only = false;  ///< its profiles are those of another kind of vehicle
  std::string_view without;  ///< a route that needs what that kind has
};

/// The files for a vehicle: profiles say how it goes to a depth, so those of one that glides are
/// not those of one with a propeller; routes are the same.
std::vector<LibraryFile> libraryFor(const platforms::Platform& platform);

/// Adds a file that has been parsed.
void addPart(const LibraryFile& part, ast::File parsed_file, Parsed& parsed);

}  // namespace glider::compiler
