// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookprog/hookprog.h"

#include "hooks/protocol/features.h"
#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr GliderRole kReportsOfHookbeh[] = {kGliderRoleHookState, kGliderRoleHookAnswered,
                                            kGliderRoleHookAnswer, kGliderRoleHookInControl};

/// The commands that hookbeh obeys beyond those of every version.
SeatOptions withHookbeh(SeatOptions options) {
  options.obeys |= kFeatureFixedFin | kFeatureActuators;
  return options;
}

}  // namespace

Hookprog::Hookprog(const GliderDictionary& dictionary, const SeatOptions& options)
    : dictionary_(&dictionary), seat_(dictionary, withHookbeh(options)) {
  for (double& value : values_) {
    value = __builtin_nan("");
  }
}

void Hookprog::run(double science_time_s, const ScienceMemory& memory,
                   const GliderByteStream& sbc) {
  memory_ = &memory;
  const SeatVehicle vehicle{this, reading, write, beat};
  seat_.serve(science_time_s, state(), vehicle, sbc);
  const bool something_came = takeFlight();
  const bool complete = cycleIsComplete(something_came, science_time_s);
  if (complete) {
    takeAnswer();
  }
  seat_.watch(state());
  if (complete) {
    time_is_new_ = false;
    cycle_is_new_ = false;
    watchHookbeh();
    if (cycles_.isNext(newestWhole(kGliderRoleCycleNumber))) {
      seat_.tick(state(), vehicle);
    } else {
      seat_.passOverStaleReport();
    }
    for (bool& fresh : fresh_) {
      fresh = false;
    }
  }
  seat_.finish(sbc, 0);
  memory_ = nullptr;
}

SeatEvent Hookprog::nextEvent() {
  return seat_.nextEvent();
}

/// True if the flight controller has set any sensor since the last call.
bool Hookprog::takeFlight() {
  bool something_came = false;
  for (uint32_t id = 0; id < dictionary_->count && id < GLIDER_MOST_SENSORS; ++id) {
    const auto number = static_cast<uint16_t>(id);
    if (isScienceSensor(*dictionary_, number)) {
      continue;
    }
    bool fresh = false;
    const double value = memory_->get(memory_->self, number, &fresh);
    if (fresh) {
      takeUpdate(number, value);
      something_came = true;
    }
  }
  return something_came;
}

void Hookprog::takeUpdate(uint16_t id, double value) {
  if (id == sensor(kGliderRoleMissionTime)) {
    time_is_new_ = isFinite(value);
  }
  if (id == sensor(kGliderRoleCycleNumber) && value != newest(kGliderRoleCycleNumber)) {
    cycle_is_new_ = value == value;
  }
  values_[id] = value;
  fresh_[id] = true;
}

/// Nothing marks the end of a flight cycle's report: it is over when no more of it comes.
bool Hookprog::cycleIsComplete(bool something_came, double now_s) {
  if (something_came) {
    settled_.begin(now_s);
  }
  if (!time_is_new_ || !cycle_is_new_) {
    waits_ = false;
    return false;
  }
  if (!waits_) {
    waits_ = true;
    unsettled_.begin(now_s);
  }
  const bool complete =
      settled_.lasts(now_s) >= kSettledSecs || unsettled_.lasts(now_s) >= kMostUnsettledSecs;
  waits_ = !complete;
  return complete;
}

void Hookprog::write(void* self, const SensorList& instruction) {
  static_cast<Hookprog*>(self)->forward(instruction);
}

/// Of two values that come by themselves one may be lost: the answer to an earlier instruction must
/// not be shown under the number of this one.
void Hookprog::takeAnswer() {
  if (fresh_[sensor(kGliderRoleHookAnswered)] && fresh_[sensor(kGliderRoleHookAnswer)]) {
    answered_sequence_ = newestWhole(kGliderRoleHookAnswered);
    const uint32_t answer = newestWhole(kGliderRoleHookAnswer);
    answer_ = answer <= UINT8_MAX && isHookAnswer(static_cast<uint8_t>(answer))
                  ? static_cast<HookAnswer>(answer)
                  : HookAnswer::None;
  }
}

/// Its words may arrive in any order: hookbeh reads them when all are there.
void Hookprog::forward(const SensorList& instruction) {
  if (hookState() == HookState::Absent) {
    return;
  }
  for (uint32_t i = 0; i < instruction.count; ++i) {
    const SensorValue& value = instruction.values[i];
    memory_->set(memory_->self, value.id, value.value);
  }
}

void Hookprog::beat(void* self, uint32_t heartbeat) {
  const auto& hookprog = *static_cast<const Hookprog*>(self);
  if (hookprog.hookState() != HookState::Absent) {
    const ScienceMemory& memory = *hookprog.memory_;
    memory.set(memory.self, hookprog.sensor(kGliderRoleHookHeartbeat), heartbeat);
  }
}

/// The vehicle's next mission may have no hookbeh; the last values that hookbeh reported then
/// remain in place. Time and cycle number both restart with a new mission; if only one does, it is
/// a false reading.
void Hookprog::watchHookbeh() {
  const double time = missionTime();
  const uint32_t cycle = newestWhole(kGliderRoleCycleNumber);
  if (time < cycle_time_s_ && cycle < cycle_number_) {
    most_without_hookbeh_ = kMostCyclesOfAnotherMission;
  }
  cycle_time_s_ = time;
  cycle_number_ = cycle;
  if (fresh_[sensor(kGliderRoleHookState)]) {
    cycles_without_hookbeh_ = 0;
    most_without_hookbeh_ = kMostCyclesWithoutHookbeh;
  } else if (++cycles_without_hookbeh_ >= most_without_hookbeh_) {
    for (const GliderRole role : kReportsOfHookbeh) {
      values_[sensor(role)] = __builtin_nan("");
    }
    answered_sequence_ = 0;
    answer_ = HookAnswer::None;
  }
}

bool Hookprog::reading(void* self, uint16_t id, double* value) {
  const auto& hookprog = *static_cast<const Hookprog*>(self);
  if (!isScienceSensor(*hookprog.dictionary_, id)) {
    *value = hookprog.values_[id];
    return hookprog.fresh_[id];
  }
  bool fresh = false;
  *value = hookprog.memory_->get(hookprog.memory_->self, id, &fresh);
  return fresh;
}

SeatState Hookprog::state() const {
  SeatState state;
  state.vehicle_time_s = missionTime();
  state.cycle = newestWhole(kGliderRoleCycleNumber);
  state.hook_state = hookState();
  state.answer = answer_;
  state.answered_sequence = answered_sequence_;
  state.session = newestWhole(kGliderRoleHookInControl);
  const double clock = newest(kGliderRoleClock);
  state.clock_s = clock >= 1 && clock < UINT32_MAX ? static_cast<uint32_t>(clock) : 0;
  return state;
}

HookState Hookprog::hookState() const {
  const uint32_t state = newestWhole(kGliderRoleHookState);
  return state <= static_cast<uint32_t>(HookState::Complete) ? static_cast<HookState>(state)
                                                             : HookState::Absent;
}

double Hookprog::missionTime() const {
  const double time = newest(kGliderRoleMissionTime);
  return time == time ? time : 0;
}

uint32_t Hookprog::newestWhole(GliderRole role) const {
  const double value = newest(role);
  return value >= 0 && value <= kMostSession ? static_cast<uint32_t>(value) : 0;
}

}  // namespace glider::hooks
