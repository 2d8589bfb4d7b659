// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"
#include "tests/containment/flight.h"

#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace glider::random_proofs {

/// The extremes of a few flights of a mission: requirements are made close to them, so that some
/// are true, some are not, and few are trivial.
struct Scouted {
  double latest = 0;  ///< mission time, s
  double statetime = 0;
  double resumetime = 0;
  double deepest = 0;  ///< m
  double below = 0;    ///< longest time from a tick at the surface to one without, s
  size_t stack = 0;
  std::vector<double> lowest, highest;             ///< by variable; NaN: it was never known
  std::set<uint32_t> entered;                      ///< states
  std::set<std::pair<uint32_t, uint32_t>> orders;  ///< the first was entered after the second
};

/// Makes the flights that `scout` looks at: calls `begin` before each, and `tick` after its start
/// and each of its ticks.
using Visit = std::function<void(const containment::Flight&)>;
void scoutingFlights(const ir::prove::ProofContext& context, uint64_t seed, const Visit& begin,
                     const Visit& tick);

Scouted scout(const ir::prove::ProofContext& context, uint64_t seed);

}  // namespace glider::random_proofs
