// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookprog/hookprog.h"

#include "hooks/protocol/features.h"

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
    : dictionary_(&dictionary),
      flight_science_link_(dictionary),
      seat_(dictionary, withHookbeh(options)) {
  for (double& value : values_) {
    value = __builtin_nan("");
  }
}

void Hookprog::run(double science_time_s, const ScienceSensors& own, const GliderByteStream& sbc,
                   const GliderByteStream& flight) {
  own_ = &own;
  const SeatVehicle vehicle{this, reading, write, beat};
  seat_.serve(science_time_s, state(), vehicle, sbc);
  takeFlight(flight);
  seat_.watch(state());
  if (time_is_new_ && cycle_is_new_) {
    time_is_new_ = false;
    cycle_is_new_ = false;
    watchHookbeh();
    if (cycles_.isNext(newestWhole(kGliderRoleCycleNumber))) {
      forwardPressure();
      seat_.tick(state(), vehicle);
    } else {
      seat_.passOverStaleReport();
    }
    for (bool& fresh : fresh_) {
      fresh = false;
    }
  }
  seat_.finish(sbc, flight_science_link_.badFrames());
  own_ = nullptr;
}

SeatEvent Hookprog::nextEvent() {
  return seat_.nextEvent();
}

void Hookprog::takeFlight(const GliderByteStream& flight) {
  constexpr uint32_t kMostUpdates = 1024;  // more than the line transmits in a second, 960 bytes
  SensorUpdate update;
  for (uint32_t i = 0; i < kMostUpdates && flight_science_link_.poll(flight, &update, 1) == 1;
       ++i) {
    takeUpdate(update);
  }
}

void Hookprog::takeUpdate(const SensorUpdate& update) {
  if (update.id == sensor(kGliderRoleMissionTime)) {
    time_is_new_ = update.value - update.value == 0;
  }
  if (update.id == sensor(kGliderRoleCycleNumber) &&
      update.value != newest(kGliderRoleCycleNumber)) {
    cycle_is_new_ = update.value == update.value;
  }
  values_[update.id] = update.value;
  fresh_[update.id] = true;
}

void Hookprog::write(void* self, const SensorList& instruction) {
  static_cast<Hookprog*>(self)->forward(instruction);
}

/// With its sequence last, which is what makes hookbeh read the rest.
void Hookprog::forward(const SensorList& instruction) {
  if (hookState() == HookState::Absent) {
    return;
  }
  SensorUpdate ordered[kMostListed];
  uint32_t count = 0;
  const SensorUpdate* sequence = nullptr;
  for (uint32_t i = 0; i < instruction.count; ++i) {
    const SensorValue& value = instruction.values[i];
    if (value.id == sensor(kGliderRoleHookSequence)) {
      sequence = &value;
    } else {
      ordered[count++] = value;
    }
  }
  if (sequence != nullptr) {
    ordered[count++] = *sequence;
  }
  (void)flight_science_link_.send(ordered,
                                  count);  // no room: the SBC gets no answer and writes it again
}

void Hookprog::beat(void* self, uint32_t heartbeat) {
  auto& hookprog = *static_cast<Hookprog*>(self);
  if (hookprog.hookState() != HookState::Absent) {
    const SensorUpdate beat{hookprog.sensor(kGliderRoleHookHeartbeat),
                            static_cast<double>(heartbeat)};
    // No room: the line is stuck, as hookbeh's timer detects.
    (void)hookprog.flight_science_link_.send(&beat, 1);
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
  }
}

/// hookbeh compares the vehicle's depth with the CTD's.
void Hookprog::forwardPressure() {
  if (sensor(kGliderRoleWaterPressure) == kNoSensor) {
    return;
  }
  pressure_ = own_->get(own_->self, sensor(kGliderRoleWaterPressure), &pressure_is_new_);
  if (pressure_is_new_ && hookState() != HookState::Absent) {
    const SensorUpdate update{sensor(kGliderRoleWaterPressure), pressure_};
    (void)flight_science_link_.send(&update, 1);  // no room: the next cycle's is newer
  }
}

bool Hookprog::reading(void* self, uint16_t id, double* value) {
  const auto& hookprog = *static_cast<const Hookprog*>(self);
  if (!isScienceSensor(*hookprog.dictionary_, id)) {
    *value = hookprog.values_[id];
    return hookprog.fresh_[id];
  }
  if (id == hookprog.sensor(kGliderRoleWaterPressure)) {
    *value = hookprog.pressure_;
    return hookprog.pressure_is_new_;
  }
  bool fresh = false;
  *value = hookprog.own_->get(hookprog.own_->self, id, &fresh);
  return fresh;
}

SeatState Hookprog::state() const {
  SeatState state;
  state.vehicle_time_s = missionTime();
  state.cycle = newestWhole(kGliderRoleCycleNumber);
  state.hook_state = hookState();
  const uint32_t answer = newestWhole(kGliderRoleHookAnswer);
  state.answer = answer <= UINT8_MAX && isHookAnswer(static_cast<uint8_t>(answer))
                     ? static_cast<HookAnswer>(answer)
                     : HookAnswer::None;
  state.answered_sequence = newestWhole(kGliderRoleHookAnswered);
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
