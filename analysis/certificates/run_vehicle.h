// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/tick_result.h"
#include "platforms/load/platform.h"

#include <vector>

namespace glider::analysis {

/// How deep the vehicle of a given run may be, by the rules V1 to V6 of docs/verification.md, here
/// in numbers. Written without the prover, as those are.
class RunVehicle {
 public:
  /// `platform` outlives this.
  explicit RunVehicle(const platforms::Platform& platform) : platform_(platform) {}

  struct Depths {
    double least = 0;
    double greatest = 0;
    /// Apart from roundings.
    [[nodiscard]] bool contains(double depth_m) const;
  };
  /// V1: at the start, m.
  [[nodiscard]] Depths atStart() const { return {0, platform_.world.start_depth_m}; }
  /// V2: when mission time has gone from `from` to `to`, s.
  [[nodiscard]] Depths later(double from, double to) const;

  /// It starts at this depth.
  void start(double depth_m);
  /// It is at this depth now.
  void moveTo(double depth_m) { depth_ = depth_m; }
  /// V3 to V6: what the tick at mission time `now` commanded.
  void obey(const std::vector<ir::Action>& actions, double now);

 private:
  void obey(const ir::CommandRun& command, double now);
  void descend(double target);
  void ascend(double target, double now);
  /// Where a dive that ends now may still get.
  [[nodiscard]] double lateBy() const;
  [[nodiscard]] double turnsWithin() const;
  [[nodiscard]] double endOfDive() const;

  const platforms::Platform& platform_;
  double depth_ = 0;
  double deepest_ = 0;
  bool climbing_ = false;
  double since_ = 0;
  double top_ = 0;
  bool anything_ = false;  ///< a behaviour in C has commanded last
};

}  // namespace glider::analysis
