// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/restarts.h"

#include "ir/prove/context/vehicle_clock.h"

#include <algorithm>
#include <limits>

namespace glider::random_proofs {
namespace {

constexpr double kHour = 3600;

double lengthOf(ir::prove::Rng& dice, double resume_within_s) {
  const double kind = dice.unit();
  const double length = kind < 0.4   ? dice.within(0, resume_within_s)
                        : kind < 0.5 ? resume_within_s
                        : kind < 0.7 ? resume_within_s + dice.within(0, 10)
                        : kind < 0.9 ? dice.within(0, 11 * kHour)
                                     : dice.within(11 * kHour, 13 * kHour);
  return ir::prove::onVehicleClock(std::max(0.0, length));
}

}  // namespace

std::optional<Restart> drawRestart(ir::prove::Rng& dice, const ir::Mission& mission,
                                   bool finished) {
  if (!dice.chance(1.0 / 30)) {
    return std::nullopt;
  }
  Restart restart;
  restart.outage_s = lengthOf(dice, mission.resume_within_s);
  const bool clock = dice.chance(0.8);
  runtime::Outage outage;
  outage.restarted = dice.chance(0.6);
  // Without a restart of the vehicle its mission's time shows the length.
  outage.length = clock || !outage.restarted ? restart.outage_s
                  : dice.chance(0.5)         ? std::numeric_limits<double>::quiet_NaN()
                                             : -1 - dice.within(0, kHour);
  outage.finished = finished;
  outage.resume_within = mission.resume_within_s;
  outage.never_after_restart = mission.new_after_restart || dice.chance(0.3);
  restart.then = runtime::continuationAfter(outage);
  restart.another_flight = finished || restart.outage_s >= runtime::kAnotherFlight;
  return restart;
}

}  // namespace glider::random_proofs
