// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/source_manager.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <optional>

namespace glider::slocum {

/// Reads the .mi file `file`. Every error is reported (GL5100-5109); empty when there was one. This
/// function does not check which behaviours exist: see checkArguments.
std::optional<MissionFile> readMission(const support::SourceManager& sources, uint32_t file,
                                       support::DiagnosticEngine& diagnostics);

/// Reads the .ma file `file`. GL5100-5114; empty when there was an error.
std::optional<ArgumentFile> readArguments(const support::SourceManager& sources, uint32_t file,
                                          support::DiagnosticEngine& diagnostics);

}  // namespace glider::slocum
