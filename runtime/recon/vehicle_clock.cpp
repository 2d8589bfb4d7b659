// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/recon/vehicle_clock.h"

#include "runtime/numbers/numbers.h"

namespace glider::runtime::recon {

double VehicleClock::timeOf(double time_of_day_s) {
  constexpr double kDay_s = 86400;
  if (!isFinite(newest_s_) || !isFinite(time_of_day_s)) {
    return unknown();
  }
  const double of_day = restOf(newest_s_, kDay_s);
  double time_s = newest_s_ - of_day + time_of_day_s;
  if (time_of_day_s - of_day > kDay_s / 2) {
    time_s -= kDay_s;
  } else if (of_day - time_of_day_s > kDay_s / 2) {
    time_s += kDay_s;
  }
  newest_s_ = time_s;
  return time_s;
}

}  // namespace glider::runtime::recon
