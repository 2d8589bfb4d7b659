// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/vehicle_file.h"

#include "hooks/hookbeh/hull.h"
#include "hooks/protocol/nap_times.h"
#include "ir/prove/context/duration_text.h"
#include "support/diagnostics/ids/vehicle.h"
#include "support/diagnostics/ids/verification.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace glider::slocum::rules {
namespace {

using slocum::BehaviourBlock;

const BehaviourBlock* find(const slocum::MissionFile& file, const char* name) {
  const auto found = std::ranges::find(file.behaviours, name, &BehaviourBlock::name);
  return found == file.behaviours.end() ? nullptr : &*found;
}

/// A limit that is switched on by a value of 0 or more.
std::optional<double> limitOf(const BehaviourBlock& abend, const char* argument) {
  const double value = abend.value(argument);
  return value >= 0 && !slocum::missionParameter(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

AbortLimits abortsOf(const slocum::MissionFile& file) {
  const BehaviourBlock* abend = find(file, "abend");
  return abend == nullptr
             ? AbortLimits()
             : AbortLimits{limitOf(*abend, "overdepth"), limitOf(*abend, "overtime"),
                           limitOf(*abend, "undervolts"), limitOf(*abend, "samedepth_for"),
                           limitOf(*abend, "no_cop_tickle_for")};
}

support::Result<VehicleFile> vehicleFileOf(const MissionFile& file, const std::string& path) {
  const BehaviourBlock* hookbeh = find(file, "hookbeh");
  if (hookbeh == nullptr) {
    // The number by which a program knows its mission file.
    const bool of_port =
        std::ranges::find(file.sensors, "u_mission_param_l", &Setting::name) != file.sensors.end();
    return support::fail(support::diagnostics::skeletonErrors, path,
                         of_port ? "it has no `yo` with the d_target_depth and c_target_depth of "
                                   "the SBC, u_mission_param_d (1000003) and _e (1000004)"
                                 : "it has no behavior `hookbeh`");
  }
  const double seconds = hookbeh->value("silence_secs");
  if (!(seconds > 0 && seconds <= hooks::kMostSilenceSecs)) {
    return support::fail(support::diagnostics::skeletonErrors, path,
                         fmt::format("silence_secs must be above 0 and at most {:.0f}, not {}",
                                     hooks::kMostSilenceSecs, seconds));
  }
  const double nap = hookbeh->value("nap_secs");
  if (!(nap >= 0 && nap <= hooks::kMostNapSecs)) {
    return support::fail(support::diagnostics::skeletonErrors, path,
                         fmt::format("nap_secs must be 0 or more and at most {:.0f}, not {}",
                                     hooks::kMostNapSecs, nap));
  }
  const std::string name = std::filesystem::path(path).filename().string();
  const double steepest = hookbeh->value("max_pitch");
  const double shallowest = hookbeh->value("min_pitch");
  const double deepest = hookbeh->value("max_depth");
  const double farthest = hookbeh->value("max_fin");
  const double pump = hookbeh->value("max_pump");
  const double battery = hookbeh->value("max_battery");
  return VehicleFile{path,
                     name,
                     {seconds, fmt::format("silence_secs {:.4g} from {}", seconds, name)},
                     {steepest, shallowest, farthest, pump, battery, deepest,
                      fmt::format("max_pitch {:.4g}, min_pitch {:.4g}, max_fin {:.4g}, max_pump "
                                  "{:.4g}, max_battery {:.4g} and max_depth {:.4g} in {}",
                                  steepest, shallowest, farthest, pump, battery, deepest, name)},
                     "hookbeh",
                     "",
                     abortsOf(file),
                     {deepest, hookbeh->value("min_altitude"), hookbeh->value("start_secs")},
                     nap};
}

Silence silenceOf(const VehicleFile& file, const ir::Mission& mission) {
  if (!mission.nap_s || file.nap_secs == 0) {
    return file.silence;
  }
  return {file.silence.seconds + file.nap_secs,
          fmt::format("silence_secs {:.4g} and nap_secs {:.4g} from {}", file.silence.seconds,
                      file.nap_secs, file.name)};
}

void checkNaps(const ir::Mission& mission, const VehicleFile& file,
               const support::SourceRange& hookbeh, support::DiagnosticEngine& diagnostics) {
  const double needed = napSecsFor(mission.nap_s.value_or(0));
  if (!mission.nap_s || file.nap_secs >= needed) {
    return;
  }
  diagnostics.report(
      support::diagnostics::controlPrevented, hookbeh,
      fmt::format(
          "the mission lets it sleep for up to {}, and hookbeh releases control {} (nap_secs "
          "{:.4g} in {})",
          ir::prove::durationOf(*mission.nap_s),
          file.nap_secs == 0 ? "in its first nap" : "after " + ir::prove::durationOf(file.nap_secs),
          file.nap_secs, file.name),
      fmt::format(
          "write `b_arg: nap_secs(s) {:.0f}` or more, which is the nap and {} around it, or "
          "shorten `nap at most` in the mission",
          needed, ir::prove::durationOf(kHookAroundNapSecs)));
}

}  // namespace glider::slocum::rules
