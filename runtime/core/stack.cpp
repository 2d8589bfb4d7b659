// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/stack.h"

#include "runtime/core/assert.h"

namespace glider::runtime {
namespace {

bool hasTarget(const GliderCaseInfo& info) {
  return info.transition == kGliderGoto || info.transition == kGliderCall;
}

Moved goTo(GliderContext& context, const Fired& fired) {
  context.stack_depth = 0;
  context.limit = fired.list == kGliderListAlways ? fired.index : GLIDER_NO_LIMIT;
  enterState(context, fired.info.target);
  return Moved::Entered;
}

Moved callState(GliderContext& context, const Fired& fired) {
  if (context.stack_depth == context.mission->stack_limit) {
    return Moved::No;
  }
  GliderFrame& frame = context.frames[context.stack_depth++];
  frame.state = context.state;
  frame.entered = context.entered;
  frame.limit = context.limit;
  if (fired.list == kGliderListAlways) {
    context.limit = fired.index;
  }
  enterState(context, fired.info.target);
  return Moved::Entered;
}

Moved returnToCaller(GliderContext& context) {
  if (context.stack_depth == 0) {
    return Moved::No;
  }
  const GliderFrame& frame = context.frames[context.stack_depth - 1];
  if (!GLIDER_ASSERT(context, frame.state < context.mission->state_count, ReturnState)) {
    return Moved::No;
  }
  --context.stack_depth;
  context.state = frame.state;
  context.entered = frame.entered;
  context.limit = frame.limit;
  context.resumed = context.mission_time;
  context.just_returned = 1;
  return Moved::Resumed;
}

}  // namespace

__attribute__((noinline)) void enterState(GliderContext& context, uint32_t state) {
  context.state = state;
  context.entered = context.mission_time;
  context.resumed = context.mission_time;
}

bool mayInterrupt(const GliderContext& context, uint32_t index) {
  const GliderCaseInfo& info = context.mission->always[index];
  if (index >= context.limit || (hasTarget(info) && info.target == context.state)) {
    return false;
  }
  if (!GLIDER_ASSERT(context, context.stack_depth <= context.mission->stack_limit,
                     InterruptDepth)) {
    return false;
  }
  for (uint32_t i = 0; hasTarget(info) && i < context.stack_depth; ++i) {
    if (context.frames[i].state == info.target) {
      return false;
    }
  }
  return true;
}

Moved makeTransition(GliderContext& context, const Fired& fired) {
  if (!GLIDER_ASSERT(context, context.stack_depth <= context.mission->stack_limit,
                     TransitionDepth) ||
      !GLIDER_ASSERT(context,
                     !hasTarget(fired.info) || fired.info.target < context.mission->state_count,
                     TransitionTarget)) {
    return Moved::No;
  }
  switch (static_cast<GliderTransition>(fired.info.transition)) {
    case kGliderGoto:
      return goTo(context, fired);
    case kGliderCall:
      return callState(context, fired);
    case kGliderReturn:
      return returnToCaller(context);
    case kGliderExit:
      context.finished = 1;
      return Moved::Finished;
    case kGliderStay:
    case kGliderDone:
      return Moved::No;
  }
  (void)GLIDER_ASSERT(context, false, TransitionKind);
  return Moved::No;
}

}  // namespace glider::runtime
