// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// The batteries: an alkaline pack of 8 MJ that falls from 14.4 V to 10 V in a straight line, and
/// what empties it.
class Battery {
 public:
  /// The electronics draw their share for `seconds`.
  void idle(double seconds) { used_j_ += kHotelPowerW * seconds; }
  /// The pump moved by `moved_cc` (positive: out) at `depth_m`.
  void pump(double moved_cc, double depth_m) {
    // Fits over strokes in real logs of a shallow piston pump: outwards it works against the
    // pressure.
    const double per_cc = moved_cc > 0 ? 0.29 + 0.018 * depth_m : -0.40;
    used_j_ += per_cc * moved_cc;
  }

  [[nodiscard]] double voltage() const {
    return kFullV - (kFullV - kEmptyV) * used_j_ / kCapacityJ;
  }
  [[nodiscard]] double ampHours() const { return used_j_ / (0.5 * (kFullV + voltage())) / 3600; }

 private:
  static constexpr double kHotelPowerW =
      1.63;  // median of a real log, submerged with the pump still
  static constexpr double kCapacityJ = 8e6;
  static constexpr double kFullV = 14.4;
  static constexpr double kEmptyV = 10.0;
  double used_j_ = 0;
};

}  // namespace glider::simulator
