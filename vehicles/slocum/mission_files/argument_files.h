// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/source_manager.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <filesystem>
#include <string>

namespace glider::slocum {

/// The vehicle's name for argument file `number` of `behaviour`: its first six letters and two
/// digits, "goto_l10.ma".
std::string argumentFileName(std::string_view behaviour, int number);

/// Reads the .ma file of every behaviour whose `args_from_file` is 0 or more from `folder`, or from
/// `mafiles` in it or beside it; its values take precedence over those of the mission file, as on
/// the vehicle. GL5107 for an invalid number, GL5113, and the diagnostics of readArguments; for a
/// missing file GL9001, or GL5115 and no effect if the behaviour drives no motors.
void applyArgumentFiles(MissionFile& mission, const std::filesystem::path& folder,
                        support::SourceManager& sources, support::DiagnosticEngine& diagnostics);

}  // namespace glider::slocum
