// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/tick_result.h"
#include "platforms/load/platform.h"

namespace glider::ir::prove {

/// How deep a vehicle may be that follows commands: the rules V1 to V6 of docs/verification.md, in
/// doubles (context/vehicle_rules.h).
class DepthLimits {
 public:
  /// Starts at `depth_m`; `platform` outlives this.
  DepthLimits(const platforms::Platform& platform, double depth_m);

  [[nodiscard]] double depth() const { return vehicle_.depth; }
  [[nodiscard]] bool climbs() const { return vehicle_.climbing; }
  /// A climb may stop above this depth, m.
  [[nodiscard]] double top() const { return vehicle_.top; }
  /// The least and the greatest depth when mission time has gone from `from` to `to`, s.
  [[nodiscard]] double lowest(double from, double to) const;
  [[nodiscard]] double highest(double from, double to) const;
  /// The vehicle is there now.
  void moveTo(double depth_m) { vehicle_.depth = depth_m; }
  /// Follows a command, which is not refused, at mission time `now`, s.
  void obey(const CommandRun& command, double now);
  /// V6: a behaviour in C may have commanded anything.
  void obeyAnything() { anything_ = true; }
  void downTo(double target);
  void upTo(double target, double now);

 private:
  /// As the rules have it.
  struct Vehicle {
    double depth, deepest;
    bool climbing;
    double since, top;
  };
  struct Limits;

  [[nodiscard]] Limits limits(double from, double to) const;

  const platforms::Platform* platform_;
  Vehicle vehicle_;
  bool anything_ = false;  ///< V6: only how fast it moves is limited
};

}  // namespace glider::ir::prove
