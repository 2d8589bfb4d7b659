// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <filesystem>

namespace glider::compiler {

/// What a file of missions is, by its name.
enum class MissionKind : unsigned char {
  Language,   ///< in the mission language, or the IR's text form
  Vehicles,   ///< .mi: one of the vehicle's own
  Arguments,  ///< .ma: arguments of a behaviour, for the vehicle's own
  Fleet,      ///< .toml: several vehicles, each with a mission
};
MissionKind kindOf(const std::filesystem::path& file);

/// GL9368 if `file` is not of the kind `needed`; it says which command reads it. A file
/// with another ending than .mission is not refused where a .mi is needed.
support::Result<void> requireKind(const std::filesystem::path& file, MissionKind needed);

}  // namespace glider::compiler
