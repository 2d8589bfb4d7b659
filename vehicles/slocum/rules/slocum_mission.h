// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/show.h"
#include "support/result.h"
#include "support/source_manager.h"
#include "vehicles/own_mission.h"

#include <memory>
#include <string>

namespace glider::slocum::rules {

/// A mission file of the vehicle, with its argument files, in `sources`. It must have a hookbeh, or
/// a `yo` of the port.
support::Result<std::unique_ptr<vehicles::OwnMission>> readSlocumMission(
    const std::string& path, support::SourceManager& sources, const support::ShowDiagnostics& show);

/// A mission file whose hookbeh has its own arguments, and of which nothing else is known.
std::unique_ptr<vehicles::OwnMission> usualSlocumMission();

}  // namespace glider::slocum::rules
