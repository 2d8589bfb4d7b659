// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/scouting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::random_proofs {
namespace {

using containment::Flight;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Where a flight is while it is looked at.
struct Look {
  double surfaced = 0;  ///< mission time, s
  std::set<uint32_t> entered;
};

void take(const Flight& flight, double surface_depth_m, Look& look, Scouted& all) {
  const containment::Tick& now = flight.now();
  all.latest = std::max(all.latest, now.time);
  all.statetime = std::max(all.statetime, now.time - now.entered);
  all.resumetime = std::max(all.resumetime, now.time - now.resumed);
  all.deepest = std::max(all.deepest, now.depth);
  all.stack = std::max(all.stack, now.result.stack.size());
  look.surfaced = now.depth <= surface_depth_m ? now.time : look.surfaced;
  all.below = std::max(all.below, now.time - look.surfaced);
  for (size_t i = 0; i < now.result.variables.size(); ++i) {
    all.lowest[i] = std::fmin(all.lowest[i], now.result.variables[i]);
    all.highest[i] = std::fmax(all.highest[i], now.result.variables[i]);
  }
  const bool entered =
      now.time == 0 ? look.entered.empty() : flight.arrived() && !now.result.just_returned;
  if (entered) {
    for (const uint32_t before : look.entered) {
      all.orders.insert({now.result.state.index, before});
    }
    look.entered.insert(now.result.state.index);
    all.entered.insert(now.result.state.index);
  }
}

}  // namespace

void scoutingFlights(const ir::prove::ProofContext& context, uint64_t seed, const Visit& begin,
                     const Visit& tick) {
  constexpr uint64_t kFlights = 4;
  constexpr size_t kTicks = 150;
  for (uint64_t i = 0; i < kFlights; ++i) {
    Flight flight(context, seed + i, {.power_cuts = i != 0, .pressing = i % 2 == 1});
    begin(flight);
    flight.start();
    tick(flight);
    for (size_t k = 0; k < kTicks && !flight.over(); ++k) {
      flight.advance();
      flight.decide();
      tick(flight);
    }
  }
}

Scouted scout(const ir::prove::ProofContext& context, uint64_t seed) {
  Scouted all;
  all.lowest.assign(context.mission.variables.size(), kUnknown);
  all.highest = all.lowest;
  Look look;
  scoutingFlights(
      context, seed, [&](const Flight&) { look = {}; },
      [&](const Flight& flight) {
        take(flight, context.platform.world.surface_depth_m, look, all);
      });
  return all;
}

}  // namespace glider::random_proofs
