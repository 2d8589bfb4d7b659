// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/stack.h"

namespace glider::runtime {
namespace {

Moved callState(GliderContext& context, uint32_t target) {
  if (context.stack_depth >= context.mission->stack_limit) {
    return Moved::No;
  }
  GliderFrame& frame = context.frames[context.stack_depth++];
  frame.state = context.state;
  frame.entered = context.entered;
  enterState(context, target);
  return Moved::Entered;
}

Moved returnToCaller(GliderContext& context) {
  if (context.stack_depth == 0) {
    return Moved::No;
  }
  const GliderFrame& frame = context.frames[--context.stack_depth];
  context.state = frame.state;
  context.entered = frame.entered;
  context.resumed = context.mission_time;
  return Moved::Resumed;
}

}  // namespace

void enterState(GliderContext& context, uint32_t state) {
  context.state = state;
  context.entered = context.mission_time;
  context.resumed = context.mission_time;
}

Moved makeTransition(GliderContext& context, const GliderCaseInfo& fired) {
  const bool has_target = fired.transition == kGliderGoto || fired.transition == kGliderCall;
  if (has_target && fired.target >= context.mission->state_count) {
    return Moved::No;
  }
  switch (fired.transition) {
    case kGliderGoto:
      context.stack_depth = 0;
      enterState(context, fired.target);
      return Moved::Entered;
    case kGliderCall:
      return callState(context, fired.target);
    case kGliderReturn:
      return returnToCaller(context);
    case kGliderExit:
      context.finished = 1;
      return Moved::Finished;
    default:
      return Moved::No;
  }
}

}  // namespace glider::runtime
