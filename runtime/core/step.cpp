// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The tick of ir/README.md.

#include "runtime/abi/context_layout.h"
#include "runtime/abi/runtime.h"
#include "runtime/core/assert.h"
#include "runtime/core/lay_out.h"
#include "runtime/core/readings.h"
#include "runtime/core/stack.h"
#include "runtime/numbers/numbers.h"

#include <string.h>

namespace glider::runtime {

__attribute__((noinline)) GliderContextLayout layoutOf(const GliderMission& mission) {
  return gliderContextLayout(&mission);
}

GliderContext* layOut(void* memory, const GliderMission& mission) {
  const GliderContextLayout layout = layoutOf(mission);
  auto* bytes = static_cast<uint8_t*>(memory);
  memset(bytes, 0, layout.bytes);
  auto* context = reinterpret_cast<GliderContext*>(bytes);
  context->mission = &mission;
  context->readings = reinterpret_cast<GliderReading*>(bytes + layout.readings);
  context->frames = reinterpret_cast<GliderFrame*>(bytes + layout.frames);
  context->memory = reinterpret_cast<GliderBehaviourMemory*>(bytes + layout.memory);
  context->variables = reinterpret_cast<double*>(bytes + layout.variables);
  context->temporals = reinterpret_cast<double*>(bytes + layout.temporals);
  context->calls = reinterpret_cast<GliderCall*>(bytes + layout.calls);
  context->intervals = reinterpret_cast<uint32_t*>(bytes + layout.intervals);
  context->notes = reinterpret_cast<GliderNote*>(bytes + layout.notes);
  context->note_values = reinterpret_cast<double*>(bytes + layout.note_values);
  return context;
}

namespace {

/// Sets the parameters; variables without a value yet are unknown.
void setVariables(GliderContext& context, const double* parameters) {
  const GliderMission& mission = *context.mission;
  for (uint32_t i = 0; i < mission.variable_count; ++i) {
    if (i >= mission.parameter_count) {
      context.variables[i] = unknown();
    } else {
      context.variables[i] = parameters != nullptr ? parameters[i] : mission.parameters[i].initial;
    }
  }
}

/// Clears the results of functions in the previous tick.
void clearCalls(GliderContext& context) {
  for (uint32_t i = 0; i < context.mission->call_count; ++i) {
    context.calls[i].made = 0;
  }
}

/// Makes all readings unknown until their sensors are seen.
void forgetReadings(GliderContext& context) {
  for (uint32_t i = 0; i < context.mission->sensor_count; ++i) {
    context.readings[i].value = unknown();
  }
}

/// Clears what the previous tick left for logs and displays.
void clearRecords(GliderContext& context) {
  context.moved_list = GLIDER_NO_LIST;
  context.moved_case = GLIDER_NO_CASE;
  context.fired_always = GLIDER_NO_CASE;
  context.fired_state = GLIDER_NO_CASE;
  context.fired_profile = GLIDER_NO_CASE;
  context.fired_route = GLIDER_NO_CASE;
  context.note_count = 0;
  context.note_value_count = 0;
  context.lost_notes = 0;
}

/// Enters or resumes the current state.
void enter(GliderContext& context, GliderPhase phase) {
  if (GliderEnter* enter = context.mission->states[context.state]->enter; enter != nullptr) {
    enter(&context, phase);
  }
}

void advance(GliderContext& context, GliderAdvance* advance) {
  if (advance != nullptr) {
    advance(&context);
  }
}

uint32_t firstTrue(GliderContext& context, GliderGuards* guards, uint32_t from) {
  return guards != nullptr ? guards(&context, from) : GLIDER_NO_CASE;
}

uint32_t fly(GliderContext& context, GliderFly* fly) {
  return fly != nullptr ? fly(&context) : GLIDER_NO_CASE;
}

/// Fires a case: its block, its transition. True if the tick is over.
bool fire(GliderContext& context, GliderAct* act, const Fired& fired) {
  if (act != nullptr) {
    act(&context, fired.index);
  }
  const Moved moved = makeTransition(context, fired);
  if (moved == Moved::No) {
    return false;
  }
  context.moved_list = fired.list;
  context.moved_case = fired.index;
  if (moved != Moved::Finished) {
    enter(context, moved == Moved::Entered ? kGliderEnter : kGliderResume);
  }
  return true;
}

/// True if a case of `always` ended the tick.
bool tryAlways(GliderContext& context) {
  const GliderMission& mission = *context.mission;
  // Every round passes at least one case.
  for (uint32_t from = 0; from < mission.always_count && from < context.limit;) {
    const uint32_t found = firstTrue(context, mission.guards, from);
    if (found == GLIDER_NO_CASE ||
        !GLIDER_ASSERT(context, found >= from && found < mission.always_count, AlwaysCase)) {
      return false;
    }
    if (mayInterrupt(context, found)) {
      context.fired_always = found;
      return fire(context, mission.act, {kGliderListAlways, found, mission.always[found]});
    }
    from = found + 1;
  }
  return false;
}

/// True if one of the state's own cases ended the tick.
bool tryState(GliderContext& context) {
  const GliderStateInfo& state = *context.mission->states[context.state];
  const uint32_t found = firstTrue(context, state.guards, 0);
  if (found == GLIDER_NO_CASE || !GLIDER_ASSERT(context, found < state.case_count, StateCase)) {
    return false;
  }
  context.fired_state = found;
  return fire(context, state.act, {kGliderListState, found, state.cases[found]});
}

/// Step 4 of a tick.
void tryLists(GliderContext& context) {
  const bool own_first = context.just_returned != 0;
  context.just_returned = 0;
  const bool over =
      own_first ? tryState(context) || tryAlways(context) : tryAlways(context) || tryState(context);
  if (!over) {
    const GliderStateInfo& state = *context.mission->states[context.state];
    context.fired_profile = fly(context, state.profile);
    context.fired_route = fly(context, state.route);
  }
}

}  // namespace
}  // namespace glider::runtime

extern "C" GliderContext* gliderStart(void* context_memory, const GliderMission* mission,
                                      const double* parameters, const GliderUpdate* updates,
                                      uint32_t count) {
  GliderContext* context = glider::runtime::layOut(context_memory, *mission);
  context->limit = GLIDER_NO_LIMIT;
  glider::runtime::clearRecords(*context);
  glider::runtime::forgetReadings(*context);
  glider::runtime::takeUpdates(*context, updates, count);
  glider::runtime::pollSensors(*context);
  glider::runtime::refreshReadings(*context);
  glider::runtime::setVariables(*context, parameters);
  if (mission->begin != nullptr) {
    mission->begin(context);
  }
  glider::runtime::enterState(*context, 0);
  glider::runtime::enter(*context, kGliderEnter);
  return context;
}

extern "C" void gliderStep(GliderContext* context, double mission_time, const GliderUpdate* updates,
                           uint32_t count) {
  glider::runtime::clearRecords(*context);
  if (context->finished != 0) {
    return;
  }
  glider::runtime::clearCalls(*context);
  if (mission_time > context->mission_time) {
    context->mission_time = mission_time;
  }
  glider::runtime::takeUpdates(*context, updates, count);
  glider::runtime::pollSensors(*context);
  glider::runtime::refreshReadings(*context);
  // The temporals of `always` first: those of a state may read them, but not the reverse.
  glider::runtime::advance(*context, context->mission->advance);
  glider::runtime::advance(*context, context->mission->states[context->state]->advance);
  glider::runtime::tryLists(*context);
}
