// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/second_family/toy_seat.h"

#include "hooks/protocol/sensors.h"

#include <cmath>

namespace glider::simulator {
namespace {

constexpr double kMostSilence = 24, kTwoPi = 6.283185307179586;

constexpr Column kColumns[] = {
    {"time", "s", [](const ColumnMoment& moment) { return moment.now_s; }},
    {"missiontime", "s", [](const ColumnMoment& /*moment*/) { return __builtin_nan(""); }},
    {"state", "id", [](const ColumnMoment& /*moment*/) { return __builtin_nan(""); }},
    {"m_depth", "m", [](const ColumnMoment& moment) { return moment.vehicle.depth(); }},
    {"true_depth", "m", [](const ColumnMoment& moment) { return moment.vehicle.depth(); }},
    {"m_lat", "deg", [](const ColumnMoment& moment) { return moment.truth.latitude_deg; }},
    {"m_lon", "deg", [](const ColumnMoment& moment) { return moment.truth.longitude_deg; }},
    {"true_lat", "deg", [](const ColumnMoment& moment) { return moment.truth.latitude_deg; }},
    {"true_lon", "deg", [](const ColumnMoment& moment) { return moment.truth.longitude_deg; }},
    {"true_x", "m", [](const ColumnMoment& moment) { return moment.vehicle.x(); }},
    {"true_y", "m", [](const ColumnMoment& moment) { return moment.vehicle.y(); }},
};

}  // namespace

ToySeat::ToySeat(const SeatSetup& setup)
    : platform_(setup.platform),
      dictionary_(setup.platform),
      array_(setup.platform),
      seat_(dictionary_.get(), {.virtual_time = !setup.real_time}) {
  state_.hook_state = hooks::HookState::Ready;
}

void ToySeat::cycle(double now_s, bool /*sbc_gone*/, Vehicle& vehicle) {
  now_s_ = now_s;
  state_.vehicle_time_s = now_s;
  ++state_.cycle;
  cycle_is_new_ = true;
  if (inControl() && now_s - beat_s_ > kMostSilence) {
    state_.hook_state = hooks::HookState::Silent;
    state_.session = 0;
    why_ = "the SBC is silent";
  }
  array_.beginCycle();
  array_.set(numberOf(platform_, "m_depth"), vehicle.depth());
  array_.set(numberOf(platform_, "m_pitch"), vehicle.pitch());
  array_.set(numberOf(platform_, "m_heading"), std::fmod(vehicle.heading() + kTwoPi, kTwoPi));
  steer(vehicle);
  if (state_.hook_state == hooks::HookState::Silent ||
      state_.hook_state == hooks::HookState::Complete) {
    end_ = News{EventId::Unlisted, {"log", "the toy comes up"}, why_};
  }
}

/// Pump and battery all the way, and the fin towards the heading.
void ToySeat::steer(Vehicle& vehicle) const {
  const bool dives = inControl() && obeyed_.vertical == hooks::HookVertical::Descend &&
                     vehicle.depth() < obeyed_.depth_m;
  const bool rests = inControl() && obeyed_.vertical == hooks::HookVertical::Hover;
  const MotorLimits& limits = vehicle.limits();
  vehicle.commandPump(rests ? 0 : dives ? -limits.pump_cc : limits.pump_cc);
  vehicle.commandBatteryPosition(rests ? 0 : dives ? 0.5 : -0.5);
  const double off = std::remainder(obeyed_.heading_rad - vehicle.heading(), kTwoPi);
  const bool turns = inControl() && obeyed_.lateral == hooks::HookLateral::Heading;
  vehicle.commandFin(turns ? std::fmin(std::fmax(off, -limits.fin_rad), limits.fin_rad) : 0);
}

bool ToySeat::serve(double now_s, const Vehicle& /*vehicle*/, SerialLine& sbc) {
  now_s_ = now_s;
  const hooks::SeatVehicle vehicle{this, reading, write, beat};
  const GliderByteStream line = sbc.left();
  seat_.serve(now_s, state_, vehicle, line);
  seat_.watch(state_);
  if (cycle_is_new_) {
    cycle_is_new_ = false;
    seat_.tick(state_, vehicle);
  }
  seat_.finish(line, 0);
  return true;
}

bool ToySeat::reading(void* self, uint16_t id, double* value) {
  const auto& array = static_cast<const ToySeat*>(self)->array_;
  *value = array.get(id);
  return array.fresh(id);
}

void ToySeat::write(void* self, const hooks::SensorList* instruction) {
  auto& toy = *static_cast<ToySeat*>(self);
  const GliderDictionary& dictionary = toy.dictionary_.get();
  hooks::InstructionWords words;
  for (const hooks::InstructionWord& one : hooks::kInstructionWords) {
    const uint16_t id = hooks::sensorOf(dictionary, one.role);
    for (uint32_t i = 0; i < instruction->count; ++i) {
      words.*one.word =
          instruction->values[i].id == id ? instruction->values[i].value : words.*one.word;
    }
  }
  if (hooks::Instruction heard; hooks::instructionOf(words, &heard)) {
    toy.obey(heard);
  }
}

void ToySeat::obey(const hooks::Instruction& instruction) {
  state_.answered_sequence = instruction.sequence;
  state_.answer = hooks::HookAnswer::Accepted;
  beat_s_ = now_s_;
  if (instruction.control == hooks::HookControl::Release) {
    state_.hook_state = hooks::HookState::Complete;
    state_.session = 0;
    return;
  }
  state_.hook_state = hooks::HookState::Active;
  state_.session = instruction.session;
  obeyed_ = instruction;
}

void ToySeat::beat(void* self, uint32_t /*heartbeat*/, bool /*asleep*/) {
  auto& toy = *static_cast<ToySeat*>(self);
  toy.beat_s_ = toy.now_s_;
}

CycleView ToySeat::view(double now_s) const {
  return {.time_s = now_s, .hook = state_.hook_state, .array = array_, .mission_s = now_s};
}

std::span<const Column> ToySeat::firstColumns() const {
  return kColumns;
}

}  // namespace glider::simulator
