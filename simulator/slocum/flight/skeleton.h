// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/result.h"
#include "support/source_manager.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <filesystem>

namespace glider::simulator {

/// Reports what the simulator cannot fly in `mission`: unknown behaviours (GL5103), b_args (GL5104,
/// GL5106), values that it does not model (GL5107), no behaviour at all (GL5108 or, with settings,
/// GL5205, at `place`). Warns about what has no effect (GL5110, GL5111, GL5116) or another one
/// (GL5206, GL5209).
void checkSkeleton(const slocum::MissionFile& mission, support::SourceRange place,
                   support::DiagnosticEngine& diagnostics);

/// Reads the vehicle's mission file `path` with its argument files, and checks that the simulator
/// can fly it. Fails with GL9001; errors in the files go to `diagnostics`, and the failure is then
/// GL5120.
support::Result<slocum::MissionFile> loadMissionFile(const std::filesystem::path& path,
                                                     support::SourceManager& sources,
                                                     support::DiagnosticEngine& diagnostics);

}  // namespace glider::simulator
