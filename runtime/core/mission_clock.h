// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

/// Mission time from the vehicle's: 0 when control was given, never going back, whatever the
/// vehicle's clock does.
namespace glider::runtime {

class MissionClock {
 public:
  /// Mission time 0 is now.
  void start(double vehicle_time, double sbc_time) {
    vehicle_ = vehicle_time;
    origin_ = vehicle_time;
    sbc_ = sbc_time;
  }

  /// A frame came: returns mission time, s. A vehicle that began its own mission anew counts from 0
  /// again; mission time then goes on from where it was.
  double atFrame(double vehicle_time, double sbc_time) {
    if (vehicle_time < vehicle_) {
      origin_ += vehicle_time - vehicle_;
    }
    vehicle_ = vehicle_time;
    sbc_ = sbc_time;
    return vehicle_ - origin_;
  }

  /// No frame came: mission time by the SBC's own clock.
  [[nodiscard]] double withoutFrame(double sbc_time) const {
    return (vehicle_ - origin_) + (sbc_time - sbc_);
  }

 private:
  double origin_ = 0;   ///< vehicle time of mission time 0
  double vehicle_ = 0;  ///< vehicle time of the newest frame
  double sbc_ = 0;      ///< SBC time of the newest frame
};

}  // namespace glider::runtime
