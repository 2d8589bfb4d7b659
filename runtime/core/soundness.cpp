// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/soundness.h"

#include "hooks/protocol/bounds.h"
#include "runtime/core/assert.h"
#include "runtime/core/lay_out.h"

#include <stddef.h>

namespace glider::runtime {
namespace {

/// A pointer of any type.
using Address = uintptr_t __attribute__((may_alias));
constexpr uint32_t kPointers = 9;
static_assert(firstOf(Check::ReadingsPointer, kPointers - 1, kPointers) ==
              Check::NoteValuesPointer);
static_assert(offsetof(GliderContext, mission_time) ==
                  offsetof(GliderContext, readings) + kPointers * sizeof(void*) &&
              sizeof(GliderContextLayout) == (kPointers + 1) * sizeof(size_t));

/// Every array stands where the layout says.
Check brokenPointer(const GliderContext& context) {
  const GliderContextLayout layout = layoutOf(*context.mission);
  const auto* offsets = reinterpret_cast<const size_t*>(&layout);
  const auto* pointers = reinterpret_cast<const Address*>(&context.readings);
  uint32_t i = 0;
  for (; i < kPointers; ++i) {
    if (pointers[i] != reinterpret_cast<uintptr_t>(&context) + offsets[i]) {
      break;
    }
  }
  return firstOf(Check::ReadingsPointer, i, kPointers);
}

bool isLimit(const GliderMission& mission, uint32_t limit) {
  return limit < mission.always_count || limit == GLIDER_NO_LIMIT;
}

Check brokenStack(const GliderContext& context) {
  const GliderMission& mission = *context.mission;
  if (context.stack_depth > mission.stack_limit) {
    return Check::StackDepth;
  }
  for (uint32_t i = 0; i < context.stack_depth; ++i) {
    if (context.frames[i].state >= mission.state_count) {
      return Check::StackState;
    }
    if (!isLimit(mission, context.frames[i].limit)) {
      return Check::StackLimit;
    }
  }
  return Check::None;
}

Check brokenNumber(const GliderContext& context) {
  // In the order of log/checks.def.
  static constexpr hooks::Bound kBounds[] = {
      {offsetof(GliderContext, finished), 1, 4},
      {offsetof(GliderContext, just_returned), 1, 4},
      {offsetof(GliderContext, vertical), kGliderActuators, 4},
      {offsetof(GliderContext, lateral), kGliderFin, 4},
  };
  constexpr uint32_t kCount = sizeof kBounds / sizeof kBounds[0];
  static_assert(firstOf(Check::FinishedFlag, kCount - 1, kCount) == Check::LateralCommand);
  const GliderMission& mission = *context.mission;
  if (context.state >= mission.state_count) {
    return Check::CurrentState;
  }
  return !isLimit(mission, context.limit)
             ? Check::CaseLimit
             : firstOf(Check::FinishedFlag, hooks::firstPast(&context, kBounds), kCount);
}

}  // namespace

Check brokenPart(const GliderContext& context, const GliderMission& mission) {
  if (context.mission != &mission) {
    return Check::MissionPointer;
  }
  Check broken = brokenPointer(context);  // the rest reads through the pointers
  broken = broken == Check::None ? brokenNumber(context) : broken;
  return broken == Check::None ? brokenStack(context) : broken;
}

}  // namespace glider::runtime
