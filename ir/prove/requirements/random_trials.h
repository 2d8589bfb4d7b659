// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/requirements/strategy_context.h"

#include <optional>

namespace glider::ir::prove {

/// A random flight that violates `requirement` (Reach: satisfies), and the simplest that is found:
/// tries one seed after the other until so many ticks are flown as the options and the budget
/// allow. `proof_context`: with power cuts or without. `round`: 0, or more for that many other
/// flights.
std::optional<Counterexample> tryAtRandom(const Requirement& requirement,
                                          const ProofContext& proof_context,
                                          StrategyContext& context, unsigned round = 0);

/// The same by flights twice as long as the longest time that the mission names, in which every
/// tick comes as late as it may without a power cut; none is tried if the others are as long.
std::optional<Counterexample> tryForLong(const Requirement& requirement,
                                         const ProofContext& proof_context,
                                         StrategyContext& context);

/// The same by flights of hours, of a requirement that is seen broken within less: what a case
/// above undoes may take long to come about. None is tried if the others are nearly as long.
std::optional<Counterexample> tryForHours(const Requirement& requirement,
                                          const ProofContext& proof_context,
                                          StrategyContext& context);

/// `found`, a violation of `requirement` (Reach: how it is satisfied), or one with fewer
/// transitions, or as many in less time, if random flights that are no longer find one soon.
Counterexample simplest(Counterexample found, const Requirement& requirement,
                        const ProofContext& proof_context, StrategyContext& context);

}  // namespace glider::ir::prove
