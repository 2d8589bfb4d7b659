// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <vector>

namespace glider::ir::prove {

/// What moments that were tried out show of a case. What is false was not seen, which shows
/// nothing.
struct Seen {
  bool fires = false;  ///< its guard is true
  bool idle = false;   ///< its guard is not true
  bool first = false;  ///< its guard is true and that of no earlier case is
};

/// Tries each case of a list at a few moments around the values that its guard compares with. A
/// moment that was seen is one that a solver would find, so nothing has to be asked that it
/// answers: most guards of most missions do not need the solver, which takes a hundred times as
/// long. Guards that look back in time or call C functions are not tried.
std::vector<Seen> tryOut(const ProofContext& proof_context, const std::vector<Case>& cases);

}  // namespace glider::ir::prove
