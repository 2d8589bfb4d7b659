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

/// Makes the transition of `fired` at the context's mission time. A call on a full stack, a return
/// on an empty one and a target that is no state change nothing: the verifier proves that none
/// happens, and a vehicle must not depend on it.
Moved makeTransition(GliderContext& context, const GliderCaseInfo& fired);

/// Makes `state` current, entered now.
void enterState(GliderContext& context, uint32_t state);

}  // namespace glider::runtime
