// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/bottom_memory.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/echo_floor.h"

namespace glider::hooks {

/// Where the bottom is, from the altimeter's echoes and from contacts: a dive that stops, from
/// whose depth the vehicle then climbs as its depth shows.
class Bottom {
 public:
  /// Takes in one cycle, `step_s` after the previous one. `depth_m`: NaN while it is not believed.
  /// `least_altitude_m`: how far the vehicle stays above the bottom.
  void observe(const Surroundings& now, double depth_m, double least_altitude_m, double step_s);
  /// What the sensor array holds before the first cycle is not an echo.
  void ignore(double altitude_m) { echoes_.ignore(altitude_m); }
  /// Where the vehicle is; must be called before observe(), apart from it for the sake of the
  /// stack.
  void move(const Surroundings& now, double least_altitude_m, double step_s);
  /// Follows the dives, and confirms a stop once the depth has followed the climb: a depth sensor
  /// that is stuck would not. Must be called after observe().
  void follow(double step_s);
  /// A dive stopped in this cycle, and the vehicle climbs from now on. Where the depth did not
  /// follow the climb after the stop before it is stuck, and no stop counts until it has moved.
  void noteStop();
  /// The least depth of the bottom where the vehicle is now, m; kBottomless if nothing is known.
  [[nodiscard]] double floor() const;
  /// The same by contacts alone, for a vehicle that uses no altimeter.
  [[nodiscard]] double touchedFloor() const;

 private:
  void confirm();
  void noteTurn(double depth_m);
  void judgeEcho(double depth_m);

  EchoFloor echoes_;
  BottomMemory memory_;
  double depth_m_ = __builtin_nan("");
  double dive_m_ = __builtin_nan("");  ///< the greatest depth of the newest dive
  bool sinks_ = true;                  ///< it has not turned
  double top_m_ = 0;                   ///< the least depth since it did
  double stop_m_ = __builtin_nan("");  ///< where a dive stopped; NaN if none has to be confirmed
  double stop_last_m_ = 0;             ///< the newest depth since then, and its age
  double stop_gap_s_ = 0;
  double stop_age_s_ = 0;                     ///< since that stop
  double stop_far_m_ = 0;                     ///< how far the depth has been from it since then
  double stuck_m_ = __builtin_nan("");        ///< a depth that follows no climb; NaN: none
  bool believed_ = true;                      ///< the altimeter: no contact contradicts it
  double agrees_from_m_ = __builtin_nan("");  ///< range of depths at which it agreed with a contact
  double agrees_to_m_ = __builtin_nan("");
  double agreed_ = 0;  ///< how many echoes did
  bool failed_ = false;
};

}  // namespace glider::hooks
