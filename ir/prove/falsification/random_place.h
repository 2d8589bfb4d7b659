// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/tick_result.h"
#include "ir/prove/falsification/rng.h"
#include "platforms/load/platform.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// A place inside an area as `isInside` counts, or none if 1000 tries do not find one. It tries
/// triangles of neighbouring corners: some of them are all inside if the area does not cross
/// itself.
std::optional<Position> placeInside(const Geofence& area, Rng& dice);

/// The position of a vehicle that follows a mission's commands in a current, and in the wind at the
/// surface: the assumptions of ir/prove/geometry/geofences.h, in numbers. It always knows its
/// position.
class RandomPlace {
 public:
  /// Begins at `start`. `platform` and `dice` outlive this.
  RandomPlace(const Position& start, const platforms::Platform& platform, Rng& dice);

  [[nodiscard]] const Position& where() const { return place_; }
  /// Follows the commands of a tick.
  void obey(const std::vector<Action>& actions);
  /// Moves through the water, and is set by the current, or at the surface by current and wind, for
  /// so many seconds. While the SBC is `dark` (without power) it goes straight on in any direction.
  void move(double seconds, bool at_surface, bool dark);

 private:
  /// A command about the heading, with known arguments.
  void steer(const CommandRun& run);
  [[nodiscard]] double course();
  void go(double course, double metres);

  const platforms::Platform& platform_;
  Rng& dice_;
  Position place_;
  std::optional<Position> target_;
  double heading_ = 0;  ///< rad, while it steers to no waypoint
  double turn_ = 0;     ///< rad/s, while its fin is held
  double speed_ = 0;    ///< through the water, m/s
  double set_ = 0;      ///< direction in which the current sets it, rad
  double drift_ = 0;    ///< under water, m/s
  double surface_drift_ = 0;
};

}  // namespace glider::ir::prove
