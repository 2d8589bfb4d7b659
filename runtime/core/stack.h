// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"

/// The transitions of ir/README.md on the context's state and stack of frames.
namespace glider::runtime {

/// What a transition did to the current state.
enum class Moved : uint8_t {
  No,        ///< stay, or a transition that cannot be made
  Entered,   ///< goto, call
  Resumed,   ///< return
  Finished,  ///< exit
};

/// A case that fires: number `index` of `list`.
struct Fired {
  uint32_t list;   ///< GliderList
  uint32_t index;  ///< its number
  const GliderCaseInfo& info;
};

/// Makes the transition of `fired` at the context's mission time. A call on a full stack, a return
/// on an empty one, and a target that is not a state change nothing. The verifier proves that none
/// of these happens; the vehicle must not depend on that proof.
Moved makeTransition(GliderContext& context, const Fired& fired);

/// Makes `state` current, entered now.
void enterState(GliderContext& context, uint32_t state);

/// True if case `index` of `always` may fire now: it is before the limit, and its target is neither
/// current nor on the stack.
bool mayInterrupt(const GliderContext& context, uint32_t index);

}  // namespace glider::runtime
