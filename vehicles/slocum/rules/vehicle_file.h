// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "support/diagnostics/engine.h"
#include "support/result.h"
#include "vehicles/slocum/mission_files/mission_file.h"
#include "vehicles/slocum/rules/refused_commands.h"
#include "vehicles/slocum/rules/way_home.h"

#include <optional>
#include <string>

namespace glider::slocum::rules {

/// Where `abend` ends the vehicle's mission; empty: nowhere, or only the vehicle knows (a mission
/// parameter).
struct AbortLimits {
  std::optional<double> overdepth_m;
  std::optional<double> overtime_s;  ///< since the vehicle's mission began
  std::optional<double> undervolts_V;
  std::optional<double> samedepth_for_s;  ///< under water, within 1 m
  std::optional<double> untickled_s;      ///< since the last fix or contact
};

/// Where hookbeh makes the vehicle climb, for any command of the SBC, and from when on it is ready.
struct GuardLimits {
  double greatest_depth_m = 0;
  double least_altitude_m = 0;  ///< negative: hookbeh uses no altimeter
  double start_secs = 0;        ///< of the vehicle's mission
};

/// What the mission file of the vehicle says about the missions that it may give control to.
struct VehicleFile {
  std::string path;
  std::string name;  ///< of the file, without its folder
  Silence silence;
  CommandLimits commands;
  std::string refuser;  ///< what refuses other commands: "hookbeh"
  /// Where all of them are: "overdepth of abend in skeleton.mi"; empty: in the refuser's arguments.
  std::string limits_at;
  AbortLimits aborts;
  GuardLimits guards;
  double nap_secs = 0;  ///< how long beats on behalf of a sleeping SBC count; 0: it must not sleep
};

/// The longest `nap_secs` that is taken: with twice the longest nap the vehicle of a dead SBC

/// Of hookbeh, while it gives control to `mission`.
Silence silenceOf(const VehicleFile& file, const ir::Mission& mission);

/// Reports that hookbeh releases control in a nap of `mission` (GL3133), at `hookbeh`.
void checkNaps(const ir::Mission& mission, const VehicleFile& file,
               const support::SourceRange& hookbeh, support::DiagnosticEngine& diagnostics);

/// Where the `abend` of a mission file aborts.
AbortLimits abortsOf(const MissionFile& file);

/// Of the .mi file that was read from `path`. GL5120 if there is no hookbeh or its silence is not a
/// valid time.
support::Result<VehicleFile> vehicleFileOf(const MissionFile& file, const std::string& path);

}  // namespace glider::slocum::rules
