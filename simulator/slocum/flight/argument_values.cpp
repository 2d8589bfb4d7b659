// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/argument_values.h"

#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/slocum/mission_files/behaviour_catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace glider::simulator {

using support::DiagnosticEngine;

namespace {

/// The codes that the vehicle has for an enumerated b_arg.
struct Codes {
  std::string_view behaviour, argument;
  std::vector<int> codes;
};
const std::vector<int> kStart = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18};
const std::vector<int> kStop = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 15, 17, 18};
const std::vector<int> kFlag = {0, 1};
const std::vector<int> kPump = {0, 1, 2, 3, 5};
const std::vector<int> kUnits = {0, 1, 2};
const std::vector<int> kPitch = {1, 2, 3};
const std::vector<int> kEnd = {0, 2};
const std::vector<int> kEndOfLeg = {0, 1, 2, 3, 4, 5};
const auto kCodes = std::to_array<Codes>({
    {"surface", "start_when", kStart},
    {"surface", "end_action", {0, 1, 2, 3, 4, 5}},
    {"surface", "c_use_bpump", kPump},
    {"surface", "c_use_pitch", kPitch},
    {"yo", "start_when", kStart},
    {"yo", "end_action", kEnd},
    {"yo", "stop_when", kStop},
    {"yo", "start_diving", {0, 1, 2}},
    {"yo", "d_use_bpump", kPump},
    {"yo", "c_use_bpump", kPump},
    {"yo", "d_use_pitch", kPitch},
    {"yo", "c_use_pitch", kPitch},
    {"set_heading", "start_when", kStart},
    {"set_heading", "stop_when", kStop},
    {"set_heading", "end_action", kEnd},
    {"set_heading", "use_heading", {1, 2, 3, 4, 5}},
    {"goto_wpt", "start_when", kStart},
    {"goto_wpt", "stop_when", kStop},
    {"goto_wpt", "end_action", kEndOfLeg},
    {"goto_wpt", "wpt_units", kUnits},
    {"goto_list", "start_when", kStart},
    {"goto_list", "list_stop_when", kStop},
    {"goto_list", "end_action", {0, 2, 6}},
    {"dive_to", "start_when", kStart},
    {"dive_to", "use_bpump", kPump},
    {"dive_to", "use_pitch", kPitch},
    {"dive_to", "end_action", kEnd},
    {"climb_to", "start_when", kStart},
    {"climb_to", "use_bpump", kPump},
    {"climb_to", "use_pitch", kPitch},
    {"climb_to", "end_action", kEnd},
    {"prepare_to_dive", "start_when", {0, 1, 2, 3, 4, 5, 8, 11, 14}},  // it has no other b_args
    {"drift_at_depth", "start_when", kStart},
    {"drift_at_depth", "end_action", kEnd},
    {"drift_at_depth", "use_pitch", kPitch},
    {"drift_at_depth", "d_use_bpump", kPump},
    {"drift_at_depth", "c_use_bpump", kPump},
    {"drift_at_depth", "d_use_pitch", kPitch},
    {"drift_at_depth", "c_use_pitch", kPitch},
    {"mission_ender", "start_when", kStart},
    {"oob_abort", "start_when", kStart},
    {"hookbeh", "d_use_bpump", {0, 2}},
    {"hookbeh", "c_use_bpump", {0, 2}},
});

/// Bounds of a number.
struct Bounds {
  std::string_view behaviour, argument;
  double lowest, highest;
};
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kSteep = 1.2;  // rad
constexpr auto kBounds = std::to_array<Bounds>({
    {"yo", "num_half_cycles_to_do", -1, 999999},
    {"yo", "d_target_depth", 0, 2000},
    {"yo", "c_target_depth", 0, 2000},
    {"surface", "gps_wait_time", 0, kNoLimit},
    {"surface", "keystroke_wait_time", 0, kNoLimit},
    {"sample", "state_to_sample", 0, 15},
    {"hookbeh", "start_secs", 0, kNoLimit},
    {"hookbeh", "max_depth", 1, 2000},
    {"hookbeh", "max_pitch", 0.1, kSteep},
    {"hookbeh", "min_pitch", 0, kSteep},
    {"hookbeh", "max_fin", 0, kSteep},
    {"hookbeh", "max_pump", 0, 1000},
    {"hookbeh", "max_battery", 0, 3},
    {"hookbeh", "silence_secs", 8, 3600},
    {"hookbeh", "nap_secs", 0, 3660},
    {"hookbeh", "hold_secs", 0, 3600},
    {"hookbeh", "d_bpump_value", -1000, 0},
    {"hookbeh", "c_bpump_value", 0, 1000},
});

/// A b_arg that this simulator does not model: it matters if it has another value than its default.
struct Unmodelled {
  std::string_view behaviour, argument;  ///< behaviour: "" for any; argument: how its name ends
  const char* why;
};
constexpr auto kUnmodelled = std::to_array<Unmodelled>({
    {"", "use_thruster", "the simulated vehicle has no thruster"},
    {"", "stop_when_air_pump", "the simulated vehicle has no air pump"},
    {"nop_cmds", "nop_air_pump", "the simulated vehicle has no air pump"},
    {"", "thruster_burst", "the simulated vehicle has no thruster"},
    {"", "use_sc_model", "the simulator does not model it"},
    {"surface", "when_utc_on_surface", "the simulated vehicle begins to climb at this time"},
    {"goto_list", "primary_wpt", "the simulated vehicle has no primary waypoint"},
    {"drift_at_depth", "depth_ctrl", "the simulated vehicle hovers with steps of its pump (0)"},
    {"drift_at_depth", "enable_steering", "the heading of other behaviours is steered anyway"},
    {"drift_at_depth", "when_utc_timestamp", "the simulator does not model it"},
    {"abend", "remaining_charge_min", "the simulator does not model it"},
    {"abend", "stalled_for", "the simulator does not model it"},
    {"abend", "eng_pressure_mul", "the simulated vehicle has no thermal engine"},
    {"abend", "use_thruster_for_ascent", "the simulated vehicle has no thruster"},
});

std::string listOf(const std::vector<int>& codes) {
  std::string out = "it must be one of ";
  const char* separator = "";
  for (const int code : codes) {
    out += separator + std::to_string(code);
    separator = ", ";
  }
  return out;
}

void checkBounds(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  for (const slocum::Setting& given : block.arguments) {
    for (const Codes& row : kCodes) {
      const auto isValue = [&](int code) { return given.value == code; };
      if (row.behaviour == block.name && row.argument == given.name &&
          std::ranges::none_of(row.codes, isValue)) {
        refuseValue(block, given, listOf(row.codes), diagnostics);
      }
    }
    for (const Bounds& row : kBounds) {
      const bool within = given.value >= row.lowest && given.value <= row.highest;
      const bool number = !slocum::missionParameter(given.value);
      if (row.behaviour == block.name && row.argument == given.name && number && !within) {
        refuseValue(block, given,
                    fmt::format("it must be between {} and {}", row.lowest, row.highest),
                    diagnostics);
      }
    }
  }
}

/// Whether a b_arg switches something on that its default does not.
bool changesFlight(const slocum::BehaviourBlock& block, const slocum::Setting& given) {
  const slocum::KnownArgument* known = slocum::findBehaviour(block.name)->find(given.name);
  return known != nullptr && given.value != known->fallback && !(given.value < 0);
}

/// What this simulator does not model, each reason once for each behaviour.
void warnOfUnmodelled(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  std::set<std::string_view> said;
  for (const slocum::Setting& given : block.arguments) {
    for (const Unmodelled& row : kUnmodelled) {
      const bool is_row = (row.behaviour.empty() || row.behaviour == block.name) &&
                          given.name.ends_with(row.argument);
      if (is_row && changesFlight(block, given) && said.insert(row.why).second) {
        diagnostics.report(support::diagnostics::argumentWithoutEffect, given.name_range,
                           given.name, block.name, row.why);
      }
    }
  }
}

/// Codes of the vehicle whose effect this simulator does not have.
void warnOfCodes(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  constexpr double kRoll = 2, kBatteryRoll = 3, kRelative = 5, kSpeed = 5;
  const auto warn = [&](support::SourceRange range, std::string_view name, const char* why) {
    diagnostics.report(support::diagnostics::argumentWithoutEffect, range, name, block.name, why);
  };
  if (block.name == "set_heading") {
    const double use = block.value("use_heading");
    const slocum::Setting* given = block.find("use_heading");
    if (use == kRoll || use == kBatteryRoll) {
      warn(given != nullptr ? given->value_range : block.range, "use_heading",
           "the simulated vehicle does not turn by rolling: it keeps its fin in the middle");
    } else if (use == kRelative) {
      warn(given->value_range, "use_heading",
           "the simulator steers `heading_value` itself, not relative to the current");
    }
  }
  for (const slocum::Setting& given : block.arguments) {
    if (given.name.ends_with("use_bpump") && given.value == kSpeed && block.name != "hookbeh") {
      warn(given.value_range, given.name,
           "the simulated vehicle does not control its speed: it moves its whole pump");
    }
  }
}

/// The pitch of a behaviour: an angle that is too steep is an error, most often in degrees. A
/// position of the battery is clipped by the vehicle.
void checkPitch(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  constexpr double kBatteryPosition = 1;
  for (const slocum::Setting& given : block.arguments) {
    if (!given.name.ends_with("pitch_value") || slocum::missionParameter(given.value)) {
      continue;
    }
    const std::string use = given.name.substr(0, given.name.size() - 11) + "use_pitch";
    const slocum::KnownBehaviour& known = *slocum::findBehaviour(block.name);
    if (known.find(given.name) == nullptr) {
      continue;
    }
    const bool battery = block.value(use) == kBatteryPosition;
    if (!battery && !(std::fabs(given.value) <= kSteep)) {
      refuseValue(block, given, fmt::format("it must be between {} and {}", -kSteep, kSteep),
                  diagnostics);
    } else if (battery && !(std::fabs(given.value) <= kBatteryTravelIn)) {
      diagnostics.report(support::diagnostics::argumentClipped, given.value_range, given.name,
                         given.value, std::copysign(kBatteryTravelIn, given.value), use);
    }
  }
}

}  // namespace

void refuseValue(const slocum::BehaviourBlock& block, const slocum::Setting& given,
                 const std::string& why, DiagnosticEngine& diagnostics) {
  diagnostics
      .report(support::diagnostics::argumentValue, given.value_range, given.name, given.value, why)
      .note(block.range, "in this behaviour");
}

void checkValues(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  checkBounds(block, diagnostics);
  checkPitch(block, diagnostics);
  warnOfUnmodelled(block, diagnostics);
  warnOfCodes(block, diagnostics);
}

}  // namespace glider::simulator
