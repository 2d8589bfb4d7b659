// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/falsification/counterexample.h"

#include <cstdint>
#include <optional>
#include <span>

namespace glider::ir::prove {

struct ProofContext;

/// A flight of random numbers in the world that proofs assume (ir/prove/encoding/world.h), written
/// without terms or solver: finds what a search misses, and is the judge of what was proved.
/// Parameters anywhere in their ranges, readings anywhere in theirs and often next to a number that
/// the mission compares with, or unknown; the vehicle anywhere that its commands allow. A flight
/// cycle between two ticks, now and then as long as ticks may be apart.
///
/// Ends when one of the requirements is broken (of Reach: kept), which is the run that it returns,
/// when the mission ends, or after `ticks`. The same for the same `seed`.
std::optional<Counterexample> flyAtRandom(const ProofContext& proof_context, uint32_t stack_depth,
                                          std::span<const Requirement> requirements, uint64_t seed,
                                          size_t ticks);

/// The same for one requirement.
inline std::optional<Counterexample> flyAtRandom(const ProofContext& proof_context,
                                                 uint32_t stack_depth,
                                                 const Requirement& requirement, uint64_t seed,
                                                 size_t ticks) {
  return flyAtRandom(proof_context, stack_depth, std::span(&requirement, 1), seed, ticks);
}

}  // namespace glider::ir::prove
