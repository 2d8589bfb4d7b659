// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "support/source_range.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::slocum::rules {

/// What hookbeh refuses by its arguments in the vehicle's mission file: the previous command then
/// stays in force. The limits of the platform are wider, and commands beyond them are errors.
struct CommandLimits {
  double steepest_pitch_rad = 0;
  double shallowest_pitch_rad = 0;
  double greatest_fin_rad = 0;
  double greatest_pump_cc = 0;
  double greatest_battery_in = 0;
  std::optional<double> greatest_depth_m;  ///< none: it depends too much on the mission file
  std::string source;                      ///< "assuming max_pitch 0.61, min_pitch 0.19, …"
};

/// The limits of pitch, fin, pump and battery that hookbeh uses if its mission file gives none.
CommandLimits usualLimits();
/// `max_depth` of the deepest mission file that comes with glidercc, scenarios/skeleton.mi, m.
inline constexpr double kBundledGreatestDepth_m = 60;
/// A line for the report if hookbeh would refuse the mission's deepest dive by that file.
std::optional<std::string> deeperThanBundledLine(const ir::Mission& mission);

/// Commands that hookbeh refuses, for some values of parameters and variables.
struct Refusal {
  support::SourceRange range;  ///< of the name of their state; invalid: of `always`
  std::string who;             ///< "`survey`", "`always`"
  std::string command;         ///< "a pitch of 40 deg"
  std::string limit;           ///< "more than 35 deg"
  std::string argument = {};   ///< of hookbeh, that sets the limit: "max_pitch"
};
std::vector<Refusal> refusalsOf(const ir::Mission& mission, const CommandLimits& limits);

/// The deepest dive or hover that a state may command, for each that commands one.
struct Dive {
  support::SourceRange range;  ///< as of Refusal
  std::string who;
  double depth_m = 0;
};
std::vector<Dive> divesOf(const ir::Mission& mission);

/// What refusalsOf() finds as lines for the report.
std::vector<std::string> refusedLines(const ir::Mission& mission, const CommandLimits& limits);

}  // namespace glider::slocum::rules
