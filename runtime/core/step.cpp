// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/context_layout.h"
#include "runtime/abi/runtime.h"
#include "runtime/core/readings.h"
#include "runtime/core/stack.h"

#include <string.h>

namespace glider::runtime {
namespace {

/// The case whose guard is true; GLIDER_NO_CASE also for a number that the state does not have.
uint32_t firingCase(const GliderContext& context) {
  const uint32_t fired = context.mission->guards(&context);
  return fired < context.mission->states[context.state].case_count ? fired : GLIDER_NO_CASE;
}

uint32_t phaseAfter(Moved moved) {
  switch (moved) {
    case Moved::Entered:
      return kGliderEnter;
    case Moved::Resumed:
      return kGliderResume;
    default:
      return kGliderTick;
  }
}

}  // namespace
}  // namespace glider::runtime

extern "C" GliderContext* gliderStart(void* context_memory, const GliderMission* mission,
                                      const GliderUpdate* updates, uint32_t count) {
  const GliderContextLayout layout =
      gliderContextLayout(mission->sensor_count, mission->stack_limit, mission->memory_count);
  auto* bytes = static_cast<uint8_t*>(context_memory);
  memset(bytes, 0, layout.bytes);
  auto* context = reinterpret_cast<GliderContext*>(bytes);
  context->mission = mission;
  context->readings = reinterpret_cast<GliderReading*>(bytes + layout.readings);
  context->frames = reinterpret_cast<GliderFrame*>(bytes + layout.frames);
  context->memory = reinterpret_cast<GliderBehaviourMemory*>(bytes + layout.memory);
  context->fired_case = GLIDER_NO_CASE;
  glider::runtime::takeUpdates(*context, updates, count);
  glider::runtime::refreshReadings(*context);
  glider::runtime::enterState(*context, 0);
  mission->fly(context, kGliderEnter);
  return context;
}

extern "C" void gliderStep(GliderContext* context, double mission_time, const GliderUpdate* updates,
                           uint32_t count) {
  using glider::runtime::Moved;
  if (context->finished != 0) {
    return;
  }
  if (mission_time > context->mission_time) {
    context->mission_time = mission_time;
  }
  glider::runtime::takeUpdates(*context, updates, count);
  glider::runtime::refreshReadings(*context);
  context->fired_case = glider::runtime::firingCase(*context);
  Moved moved = Moved::No;
  if (context->fired_case != GLIDER_NO_CASE) {
    const GliderStateInfo& state = context->mission->states[context->state];
    moved = glider::runtime::makeTransition(*context, state.cases[context->fired_case]);
  }
  if (moved != Moved::Finished) {
    context->mission->fly(context, glider::runtime::phaseAfter(moved));
  }
}
