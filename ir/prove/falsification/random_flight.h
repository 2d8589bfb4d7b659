// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/falsification/counterexample.h"

#include <cstdint>
#include <optional>
#include <span>

namespace glider::ir::prove {

struct ProofContext;

/// How far a random flight is followed.
struct FlightLength {
  size_t ticks = 0;
  /// Every tick comes as late as it may without a power cut: the same time in fewer ticks. A flight
  /// whose readings stay the same is given up if they lead out of the first state at once: most
  /// readings do, and to see what a mission does after many hours others are needed.
  bool sparse = false;
};

/// A random flight.
struct Flight {
  std::optional<Counterexample> violation;
  size_t ticks = 0;       ///< that it has taken
  bool given_up = false;  ///< by FlightLength::sparse
};

/// A random flight in the environment model of proofs (docs/verification.md), written without
/// terms or solver: it finds counterexamples that a search misses, and is the reference for what
/// was proved. Parameters are anywhere in their ranges; readings are anywhere in theirs, often next
/// to a number that the mission compares with, or unknown; the vehicle is anywhere that its
/// commands allow. Ticks are a flight cycle apart, sometimes as far apart as they may be.
///
/// Ends when one of the requirements is violated (for Reach: satisfied), and returns that trace; or
/// when the mission ends, or after `ticks`. The same `seed` gives the same flight.
std::optional<Counterexample> flyAtRandom(const ProofContext& proof_context, uint32_t stack_depth,
                                          std::span<const Requirement> requirements, uint64_t seed,
                                          size_t ticks);

/// The first of `requirements` that asks for the place of the vehicle, of which a flight then has
/// one; null if none does.
const Requirement* aboutPlaceOf(const ProofContext& proof_context,
                                std::span<const Requirement> requirements);

/// The same for one requirement; `place` is aboutPlaceOf it, computed once for many flights.
Flight flyAtRandom(const ProofContext& proof_context, uint32_t stack_depth,
                   const Requirement& requirement, const Requirement* place, uint64_t seed,
                   FlightLength length);

/// The same for one requirement.
inline std::optional<Counterexample> flyAtRandom(const ProofContext& proof_context,
                                                 uint32_t stack_depth,
                                                 const Requirement& requirement, uint64_t seed,
                                                 size_t ticks) {
  return flyAtRandom(proof_context, stack_depth, std::span(&requirement, 1), seed, ticks);
}

}  // namespace glider::ir::prove
