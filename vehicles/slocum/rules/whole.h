// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/worlds/worlds.h"
#include "platforms/load/platform.h"
#include "support/diagnostics/engine.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <string>
#include <vector>

namespace glider::slocum::rules {

/// A part of the time to the surface, and the side condition on which it rests.
struct Part {
  std::string what;  ///< "silence_secs"
  double seconds = 0;
  bool operator==(const Part&) const = default;
};

/// One way in which the SBC's control ends, and what brings the vehicle to the surface then.
struct Ending {
  std::string after;           ///< "`exit`"
  std::vector<Part> parts;     ///< their sum is the time to the surface, if that is proved
  std::string by;              ///< "behaviour 3 `surface` (start_when 1)"
  std::string why_not;         ///< why it is not proved; empty: it is
  std::string change;          ///< what to change then
  support::SourceRange range;  ///< of the behaviour that is the reason, in the mission file

  [[nodiscard]] bool proved() const { return why_not.empty(); }
  [[nodiscard]] double seconds() const;
};

/// What the vehicle's layers do when the SBC has left control, in every way in which it can.
struct Whole {
  double deepest_m = 0;  ///< upper bound of the depth, also of dives below hookbeh
  std::vector<Ending> endings;

  [[nodiscard]] bool proved() const;
  /// The endings, those that follow each other and differ only in `after` as one.
  [[nodiscard]] std::vector<Ending> alike() const;
};

/// `deepest_m`: to which the mission's own commands lead, may be infinite. `naps`: the mission lets
/// the SBC sleep. docs/verification.md has the rules and the assumptions.
Whole wholeOf(const slocum::MissionFile& vehicle, const platforms::Platform& platform,
              double deepest_m, bool naps = false);
/// The same for a mission, with the depth that its commands lead to.
Whole wholeOf(const ir::WidestWorld& world, const slocum::MissionFile& vehicle);

/// Reports the endings that are not proved (GL3127).
void reportEndings(const Whole& whole, support::DiagnosticEngine& diagnostics);

/// Lines for the report. Those for endings that are not proved are left out: they are errors.
std::vector<std::string> wholeLines(const Whole& whole);

}  // namespace glider::slocum::rules
