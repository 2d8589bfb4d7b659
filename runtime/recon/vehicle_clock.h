// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::runtime::recon {

/// The vehicle's clock. A state has only the time of day; the date is that of the vehicle's answer
/// to a query, and goes on over midnight by itself (README.md, N2).
class VehicleClock {
 public:
  /// The vehicle says what time it is, s since 1970. Only the first counts; a time before 2001 is
  /// that of a computer which does not know it.
  void set(double unix_s) {
    constexpr double kFirst = 1e9;
    newest_s_ = newest_s_ == newest_s_ || !(unix_s >= kFirst) ? newest_s_ : unix_s;
  }
  /// The time of a state, s since 1970: the one with that time of day which is nearest to the
  /// newest that is known. NaN while no date is, or if the time of day is unknown.
  double timeOf(double time_of_day_s);

 private:
  double newest_s_ = __builtin_nan("");
};

}  // namespace glider::runtime::recon
