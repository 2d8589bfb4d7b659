// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <vector>

namespace glider::ir::prove {

/// What sampling has shown about a case. False means not seen, which proves nothing.
struct SamplingResult {
  bool fires = false;  ///< its guard is true
  bool idle = false;   ///< its guard is not true
  bool first = false;  ///< its guard is true and no earlier guard is
};

/// Tries each case of a list at a few moments around the values that its guard compares with. A
/// moment that was seen is one that a solver would find, so a question that it answers need not be
/// asked: most guards of most missions do not need the solver, which takes a hundred times as long.
/// Guards that look back in time or call C functions are not tried.
std::vector<SamplingResult> tryOut(const ProofContext& proof_context,
                                   const std::vector<Case>& cases);

}  // namespace glider::ir::prove
