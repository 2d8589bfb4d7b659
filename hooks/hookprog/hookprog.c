// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookprog/hookprog.h"

#include "hooks/protocol/c_library.h"
#include "hooks/protocol/features.h"
#include "hooks/protocol/numbers.h"

static const GliderRole kReportsOfHookbeh[] = {kGliderRoleHookState, kGliderRoleHookAnswered,
                                               kGliderRoleHookAnswer, kGliderRoleHookInControl,
                                               kGliderRoleHookNapSecs};

/// With what hookbeh can do beyond what every version can: commands that it obeys, naps.
static void withHookbeh(const GliderDictionary* dictionary, HookSeatOptions* options) {
  const bool samples = hookSensorOf(dictionary, kGliderRoleHookSampling) != kHookNoSensor;
  options->obeys |= kHookFeatureFixedFin | kHookFeatureActuators;
  options->obeys |= samples ? kHookFeatureSampling : 0;
  const bool naps = hookSensorOf(dictionary, kGliderRoleHookNapSecs) != kHookNoSensor;
  options->obeys |= naps ? kHookFeatureNaps : 0;
}

void hookprogInit(Hookprog* hookprog, const GliderDictionary* dictionary,
                  const HookSeatOptions* options) {
  HookSeatOptions with_hookbeh = *options;
  withHookbeh(dictionary, &with_hookbeh);
  memset(hookprog, 0, sizeof *hookprog);
  hookprog->dictionary = dictionary;
  hookSeatInit(&hookprog->seat, dictionary, &with_hookbeh);
  for (uint32_t id = 0; id < GLIDER_MOST_SENSORS; ++id) {
    hookprog->values[id] = hookUnknown();
  }
  hookprog->most_without_hookbeh = kHookprogMostCyclesWithoutHookbeh;
}

static uint16_t sensor(const Hookprog* hookprog, GliderRole role) {
  return hookSensorOf(hookprog->dictionary, role);
}

/// Of a required role.
static double newest(const Hookprog* hookprog, GliderRole role) {
  return hookprog->values[sensor(hookprog, role)];
}

/// 0 when unknown, negative or too large.
static uint32_t newestWhole(const Hookprog* hookprog, GliderRole role) {
  const double value = newest(hookprog, role);
  return value >= 0 && value <= (double)kHookMostSession ? (uint32_t)value : 0;
}

static HookState stateOfHookbeh(const Hookprog* hookprog) {
  const uint32_t state = newestWhole(hookprog, kGliderRoleHookState);
  return state <= kHookStateComplete ? (HookState)state : kHookStateAbsent;
}

/// The longest nap that hookbeh allows, s; NaN while it has not reported it.
static double napSecs(const Hookprog* hookprog) {
  const uint16_t id = sensor(hookprog, kGliderRoleHookNapSecs);
  return id != kHookNoSensor ? hookprog->values[id] : hookUnknown();
}

static double missionTime(const Hookprog* hookprog) {
  const double time = newest(hookprog, kGliderRoleMissionTime);
  return time == time ? time : 0;
}

static void fillState(const Hookprog* hookprog, HookSeatState* state) {
  state->vehicle_time_s = missionTime(hookprog);
  state->cycle = newestWhole(hookprog, kGliderRoleCycleNumber);
  state->hook_state = stateOfHookbeh(hookprog);
  state->answer = hookprog->answer;
  state->answered_sequence = hookprog->answered_sequence;
  state->session = newestWhole(hookprog, kGliderRoleHookInControl);
  const double clock = newest(hookprog, kGliderRoleClock);
  state->clock_s = clock >= 1 && clock < UINT32_MAX ? (uint32_t)clock : 0;
  state->nap_secs = napSecs(hookprog);
}

/// What the seat asks for: HookSeatVehicle.
static bool reading(void* self, uint16_t id, double* value) {
  const Hookprog* hookprog = self;
  if (!hookIsScienceSensor(hookprog->dictionary, id)) {
    *value = hookprog->values[id];
    return hookprog->fresh[id];
  }
  bool fresh = false;
  *value = hookprog->memory->get(hookprog->memory->self, id, &fresh);
  return fresh;
}

/// A program that does not sample leaves out the word: that of another before it must not stay. It
/// is set again and again, for a value may be lost.
static void endSampling(Hookprog* hookprog, const HookSensorList* instruction) {
  const uint16_t id = sensor(hookprog, kGliderRoleHookSampling);
  bool fresh = false;
  for (uint32_t i = 0; i < instruction->count; ++i) {
    if (instruction->values[i].id == id) {
      hookprog->sampled = true;
      return;
    }
  }
  if (id != kHookNoSensor && !hookprog->sampled) {
    hookprog->sampled = hookprog->memory->get(hookprog->memory->self, id, &fresh) > 0;
  }
  if (id != kHookNoSensor && hookprog->sampled) {
    hookprog->memory->set(hookprog->memory->self, id, 0);
  }
}

/// Its words may arrive in any order: hookbeh reads them when all are there.
static void forward(void* self, const HookSensorList* instruction) {
  Hookprog* hookprog = self;
  if (stateOfHookbeh(hookprog) == kHookStateAbsent) {
    return;
  }
  for (uint32_t i = 0; i < instruction->count; ++i) {
    const HookSensorValue* value = &instruction->values[i];
    hookprog->memory->set(hookprog->memory->self, value->id, value->value);
  }
  endSampling(hookprog, instruction);
}

/// The sign tells hookbeh whether the SBC itself has answered, or sleeps.
static void passBeat(void* self, uint32_t heartbeat, bool asleep) {
  const Hookprog* hookprog = self;
  const double number = heartbeat;
  if (stateOfHookbeh(hookprog) != kHookStateAbsent) {
    hookprog->memory->set(hookprog->memory->self, sensor(hookprog, kGliderRoleHookHeartbeat),
                          asleep ? -number : number);
  }
}

static void takeUpdate(Hookprog* hookprog, uint16_t id, double value) {
  if (id == sensor(hookprog, kGliderRoleMissionTime)) {
    hookprog->time_is_new = hookIsFinite(value);
  }
  if (id == sensor(hookprog, kGliderRoleCycleNumber) &&
      value != newest(hookprog, kGliderRoleCycleNumber)) {
    hookprog->cycle_is_new = value == value;
  }
  hookprog->values[id] = value;
  hookprog->fresh[id] = true;
}

/// True if the flight controller has set any sensor since the last call.
static bool takeFlight(Hookprog* hookprog) {
  bool something_came = false;
  for (uint32_t id = 0; id < hookprog->dictionary->count && id < GLIDER_MOST_SENSORS; ++id) {
    const uint16_t number = (uint16_t)id;
    if (hookIsScienceSensor(hookprog->dictionary, number)) {
      continue;
    }
    bool fresh = false;
    const double value = hookprog->memory->get(hookprog->memory->self, number, &fresh);
    if (fresh) {
      takeUpdate(hookprog, number, value);
      something_came = true;
    }
  }
  return something_came;
}

/// Nothing marks the end of a flight cycle's report: it is over when no more of it comes.
static bool cycleIsComplete(Hookprog* hookprog, bool something_came, double now_s) {
  if (something_came) {
    hookSinceBegin(&hookprog->settled, now_s);
  }
  if (!hookprog->time_is_new || !hookprog->cycle_is_new) {
    hookprog->waits = false;
    return false;
  }
  if (!hookprog->waits) {
    hookprog->waits = true;
    hookSinceBegin(&hookprog->unsettled, now_s);
  }
  const bool complete =
      hookSinceLasts(&hookprog->settled, now_s) >= (double)kHookprogSettledSecs ||
      hookSinceLasts(&hookprog->unsettled, now_s) >= (double)kHookprogMostUnsettledSecs;
  hookprog->waits = !complete;
  return complete;
}

/// Of two values that come by themselves one may be lost: the answer to an earlier instruction must
/// not be shown under the number of this one.
static void takeAnswer(Hookprog* hookprog) {
  if (hookprog->fresh[sensor(hookprog, kGliderRoleHookAnswered)] &&
      hookprog->fresh[sensor(hookprog, kGliderRoleHookAnswer)]) {
    hookprog->answered_sequence = newestWhole(hookprog, kGliderRoleHookAnswered);
    const uint32_t answer = newestWhole(hookprog, kGliderRoleHookAnswer);
    hookprog->answer =
        answer <= UINT8_MAX && hookIsAnswer((uint8_t)answer) ? (HookAnswer)answer : kHookAnswerNone;
  }
}

static void forgetHookbeh(Hookprog* hookprog) {
  for (uint32_t i = 0; i < sizeof kReportsOfHookbeh / sizeof kReportsOfHookbeh[0]; ++i) {
    const uint16_t id = sensor(hookprog, kReportsOfHookbeh[i]);
    if (id != kHookNoSensor) {
      hookprog->values[id] = hookUnknown();
    }
  }
  hookprog->answered_sequence = 0;
  hookprog->answer = kHookAnswerNone;
}

/// The vehicle's next mission may have no hookbeh; the last values that hookbeh reported then
/// remain in place. Time and cycle number both restart with a new mission; if only one does, it is
/// a false reading.
static void watchHookbeh(Hookprog* hookprog) {
  const double time = missionTime(hookprog);
  const uint32_t cycle = newestWhole(hookprog, kGliderRoleCycleNumber);
  if (time < hookprog->cycle_time_s && cycle < hookprog->cycle_number) {
    hookprog->most_without_hookbeh = kHookprogMostCyclesOfAnotherMission;
  }
  hookprog->cycle_time_s = time;
  hookprog->cycle_number = cycle;
  if (hookprog->fresh[sensor(hookprog, kGliderRoleHookState)]) {
    hookprog->cycles_without_hookbeh = 0;
    hookprog->most_without_hookbeh = kHookprogMostCyclesWithoutHookbeh;
  } else if (++hookprog->cycles_without_hookbeh >= hookprog->most_without_hookbeh) {
    forgetHookbeh(hookprog);
  }
}

static void endCycle(Hookprog* hookprog, const HookSeatState* state,
                     const HookSeatVehicle* vehicle) {
  if (hookprogCycleIsNext(&hookprog->cycles, state->cycle)) {
    hookSeatTick(&hookprog->seat, state, vehicle);
  } else {
    hookSeatPassOverStaleReport(&hookprog->seat);
  }
  memset(hookprog->fresh, 0, sizeof hookprog->fresh);
}

void hookprogRun(Hookprog* hookprog, double science_time_s, const HookScienceMemory* memory,
                 const GliderByteStream* sbc) {
  hookprog->memory = memory;
  const HookSeatVehicle vehicle = {hookprog, reading, forward, passBeat};
  HookSeatState state;
  fillState(hookprog, &state);
  hookSeatServe(&hookprog->seat, science_time_s, &state, &vehicle, sbc);
  const bool something_came = takeFlight(hookprog);
  const bool complete = cycleIsComplete(hookprog, something_came, science_time_s);
  if (complete) {
    takeAnswer(hookprog);
  }
  fillState(hookprog, &state);
  hookSeatWatch(&hookprog->seat, &state);
  if (complete) {
    hookprog->time_is_new = false;
    hookprog->cycle_is_new = false;
    watchHookbeh(hookprog);
    fillState(hookprog, &state);
    endCycle(hookprog, &state, &vehicle);
  }
  hookSeatFinish(&hookprog->seat, sbc, 0);
  hookprog->memory = NULL;
}

bool hookprogWantsSbc(const Hookprog* hookprog) {
  return hookSeatWantsSbc(&hookprog->seat);
}

bool hookprogNextEvent(Hookprog* hookprog, HookSeatEvent* event) {
  return hookSeatNextEvent(&hookprog->seat, event);
}
