// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/result.h"
#include "support/source_manager.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <filesystem>
#include <functional>

namespace glider::slocum {

/// Reports what is wrong with a mission beyond its grammar; `place` is its file.
using CheckMission =
    std::function<void(const MissionFile&, support::SourceRange place, support::DiagnosticEngine&)>;

/// Reads the .mi file `path` with its argument files, and the settings of the vehicle's autoexec.mi
/// if that is beside it, or in `config` in its folder or beside that; runs `check`. Fails with
/// GL9001; errors in the files go to `diagnostics`, and the failure is then GL5120.
support::Result<MissionFile> loadMission(const std::filesystem::path& path,
                                         support::SourceManager& sources,
                                         support::DiagnosticEngine& diagnostics,
                                         const CheckMission& check);

}  // namespace glider::slocum
