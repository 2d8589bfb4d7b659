// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Derives mission time from the vehicle's time: 0 when the mission got control; it never goes
/// back, even if the vehicle's clock does.
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

  /// Continues where a clock with this anchor was when it last read the vehicle's time.
  void resume(const ClockAnchor& anchor, double vehicle_time, double sbc_time) {
    anchor_ = anchor;
    vehicle_ = vehicle_time;
    sbc_ = sbc_time;
    silence_ = asleep_ = 0;
  }
  /// From which mission time counts.
  [[nodiscard]] const ClockAnchor& anchor() const { return anchor_; }
  /// Vehicle time of the newest frame, s.
  [[nodiscard]] double vehicle() const { return vehicle_; }

  /// The vehicle's frame with cycle number `cycle` has arrived: returns mission time, s. A vehicle
  /// that restarted its own mission counts from 0 again, and one with a broken clock from any
  /// value; mission time then continues from where it was, by the SBC's own clock.
  double atFrame(double vehicle_time, uint32_t cycle, double sbc_time) {
    const double reached = missionAt(vehicle_) + silence_;
    if (!follows(vehicle_time, cycle) || reached - missionAt(vehicle_time) > kMostSilence) {
      anchor_ = {vehicle_time, reached + (passedHere(sbc_time) + asleep_)};
    }
    sbc_ = sbc_time;
    most_ = kMostSilence;
    return take(vehicle_time, cycle);
  }

  /// The same for one that the vehicle has kept while the SBC slept; newer ones follow at once.
  /// When it was made is known by the vehicle's time alone.
  double atKeptFrame(double vehicle_time, uint32_t cycle, double sbc_time) {
    const double reached = missionAt(vehicle_) + silence_;
    const double passed = vehicle_time - vehicle_;
    if (!follows(vehicle_time, cycle)) {
      anchor_ = {vehicle_time, reached + earlier(kCycle * cyclesUntil(cycle), kMostSilence)};
    }
    sbc_ = earlier(sbc_ + (passed > 0 ? passed : 0), sbc_time);
    return take(vehicle_time, cycle);
  }

  /// The SBC sleeps for up to `seconds` from now: so much longer may there be no frame.
  void sleeps(double seconds) { most_ = kMostSilence + seconds; }

  /// No frame has arrived: mission time by the SBC's own clock. A jump of that clock adds at most
  /// kMostSilence since it was last read, so that the vehicle's frames, when they resume, need no
  /// longer than that to catch up. The same after a sleep, of which the vehicle has kept the
  /// frames: its time counts only if the vehicle's own does not.
  double withoutFrame(double sbc_time) {
    const double passed = passedHere(sbc_time);
    silence_ += earlier(passed, kMostSilence);
    asleep_ += passed - earlier(passed, kMostSilence);
    sbc_ = sbc_time;
    most_ = kMostSilence;
    return missionAt(vehicle_) + silence_;
  }

 private:
  /// s; a silent link is reported every 12 s. `tick_gap_s` of the platform file is this plus one
  /// cycle.
  static constexpr double kMostSilence = 16;
  /// s; a control cycle takes 4 to 4.5. A time that advances by more per cycle that the vehicle has
  /// counted is a false reading.
  static constexpr double kMostCycle = 20;
  /// s. Of a frame that was kept, the SBC's own clock says nothing.
  static constexpr double kCycle = 4;

  /// By the SBC's own clock since it was last read, s.
  [[nodiscard]] double passedHere(double sbc_time) const {
    const double passed = sbc_time - sbc_;
    return passed > most_ ? most_ : passed > 0 ? passed : 0;
  }
  /// Cycles from the newest frame to that with this number; 1 if it is not known.
  [[nodiscard]] uint32_t cyclesUntil(uint32_t cycle) const {
    return cycle > cycle_ ? cycle - cycle_ : 1;
  }
  /// Whether that may be the vehicle's time in the frame with this number, after the newest.
  [[nodiscard]] bool follows(double vehicle_time, uint32_t cycle) const {
    const double passed = vehicle_time - vehicle_;
    return passed >= 0 && passed <= kMostCycle * cyclesUntil(cycle);
  }
  double take(double vehicle_time, uint32_t cycle) {
    cycle_ = cycle;
    vehicle_ = vehicle_time;
    silence_ = asleep_ = 0;
    return missionAt(vehicle_time);
  }
  static double earlier(double a, double b) { return a < b ? a : b; }
  [[nodiscard]] double missionAt(double vehicle_time) const {
    return anchor_.mission + (vehicle_time - anchor_.vehicle);
  }

  ClockAnchor anchor_;
  double vehicle_ = 0;          ///< vehicle time of the newest frame
  uint32_t cycle_ = 0;          ///< its number; 0: not known yet
  double sbc_ = 0;              ///< SBC time when it was last read
  double silence_ = 0;          ///< s since the newest frame
  double asleep_ = 0;           ///< s since then that silence_ leaves out
  double most_ = kMostSilence;  ///< that may have passed since it was last read
};

}  // namespace glider::runtime
