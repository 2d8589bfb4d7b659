// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Mission time from the vehicle's: 0 when control was given, never going back, whatever the
/// vehicle's clock does.
namespace glider::runtime {

/// A moment in both times, s.
struct ClockAnchor {
  double vehicle = 0;
  double mission = 0;
};

class MissionClock {
 public:
  /// Mission time 0 is now.
  void start(double vehicle_time, double sbc_time) {
    resume({vehicle_time, 0}, vehicle_time, sbc_time);
  }

  /// Goes on where a clock with this anchor was when it last saw the vehicle's.
  void resume(const ClockAnchor& anchor, double vehicle_time, double sbc_time) {
    anchor_ = anchor;
    vehicle_ = vehicle_time;
    sbc_ = sbc_time;
    silence_ = 0;
  }
  /// From which mission time counts.
  [[nodiscard]] const ClockAnchor& anchor() const { return anchor_; }
  /// Vehicle time of the newest frame, s.
  [[nodiscard]] double vehicle() const { return vehicle_; }

  /// The vehicle's frame of cycle number `cycle` came: returns mission time, s. A vehicle that
  /// began its own mission anew counts from 0 again, and one whose clock is broken from anywhere;
  /// mission time then goes on from where it was, be it by the SBC's own clock.
  double atFrame(double vehicle_time, uint32_t cycle, double sbc_time) {
    const double reached = missionAt(vehicle_) + silence_;
    const uint32_t cycles = cycle > cycle_ ? cycle - cycle_ : 1;
    const double passed = vehicle_time - vehicle_;
    if (!(passed >= 0 && passed <= kMostCycle * cycles) ||
        reached - missionAt(vehicle_time) > kMostSilence) {
      anchor_ = {vehicle_time, reached};
    }
    cycle_ = cycle;
    vehicle_ = vehicle_time;
    sbc_ = sbc_time;
    silence_ = 0;
    return missionAt(vehicle_time);
  }

  /// No frame came: mission time by the SBC's own clock. A clock that has jumped counts for no more
  /// than kMostSilence since it was last looked at: the vehicle's frames, when they come again,
  /// need no longer than that to catch up.
  double withoutFrame(double sbc_time) {
    const double passed = sbc_time - sbc_;
    sbc_ = sbc_time;
    silence_ += passed > kMostSilence ? kMostSilence : passed > 0 ? passed : 0;
    return missionAt(vehicle_) + silence_;
  }

 private:
  /// s; a silent link is told every 12 s. `tick_gap_s` of the platform file is this and a cycle.
  static constexpr double kMostSilence = 16;
  /// s; a control cycle takes 4 to 4.5. A time that goes on by more for each cycle that the vehicle
  /// has counted is a false reading.
  static constexpr double kMostCycle = 20;

  [[nodiscard]] double missionAt(double vehicle_time) const {
    return anchor_.mission + (vehicle_time - anchor_.vehicle);
  }

  ClockAnchor anchor_;
  double vehicle_ = 0;  ///< vehicle time of the newest frame
  uint32_t cycle_ = 0;  ///< its number; 0: not known yet
  double sbc_ = 0;      ///< SBC time when it was last looked at
  double silence_ = 0;  ///< s since the newest frame
};

}  // namespace glider::runtime
