// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/tick_result.h"
#include "platforms/load/platform.h"

namespace glider::ir::prove {

/// How deep a vehicle may be that follows commands: the rules of ir/prove/encoding/world.h, in
/// numbers.
class DepthLimits {
 public:
  /// Starts at `depth_m`; `platform` outlives this.
  DepthLimits(const platforms::Platform& platform, double depth_m);

  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] bool climbs() const { return climbing_; }
  /// A climb may stop above this depth, m.
  [[nodiscard]] double top() const { return top_; }
  /// The least and the greatest depth when mission time has gone from `from` to `to`, s.
  [[nodiscard]] double lowest(double from, double to) const;
  [[nodiscard]] double highest(double from, double to) const;
  /// The vehicle is there now.
  void moveTo(double depth_m) { depth_ = depth_m; }
  /// Follows a command at mission time `now`, s.
  void obey(const CommandRun& command, double now);
  /// A behaviour in C may have commanded anything.
  void obeyAnything() { anything_ = true; }
  void downTo(double target);
  void upTo(double target, double now);

 private:
  const platforms::Platform* platform_;
  double depth_;
  double deepest_;         ///< under the command in force
  bool climbing_ = false;  ///< the command in force leads up
  double since_ = 0;       ///< when the first of the commands to climb was given
  double top_ = 0;         ///< upper bound of its depth under it when it has climbed
  bool anything_ = false;
};

}  // namespace glider::ir::prove
