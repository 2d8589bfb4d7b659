// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/replay/agreeing_vehicle.h"

#include "hooks/protocol/messages.h"
#include "hooks/protocol/numbers.h"
#include "hooks/protocol/values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace glider::simulator {
namespace {

constexpr double kCycle = 4;  // s
/// Sensors from the first number up to the second are what other vehicles send.
constexpr uint16_t kFirstHeard = 0xFE00, kFirstOwn = 0xFF00;
/// Rounds of questions and answers within one cycle.
constexpr int kRounds = 4;

}  // namespace

void AgreeingVehicle::floatAtSurface() {
  origin_s_ += kCycle;
  readings_[numbers_[Sensor::m_depth]] = 0;
  cycle(origin_s_);
}

void AgreeingVehicle::offerControl(const ReplayTick& start) {
  hook_state_ = hooks::HookState::Ready;
  origin_s_ += kCycle;
  show(start.readings);
  cycle(origin_s_);
}

void AgreeingVehicle::tick(const ReplayTick& tick) {
  hook_state_ = hooks::HookState::Active;
  show(tick.readings);
  cycle(origin_s_ + tick.mission_time);
}

void AgreeingVehicle::show(const std::vector<ReplayReading>& readings) {
  for (const ReplayReading& reading : readings) {
    if (reading.sensor >= kFirstHeard && reading.sensor < kFirstOwn) {
      if (!std::isnan(reading.raw)) {
        sbc_.hearValue(reading.sensor, reading.raw);
      }
      continue;
    }
    readings_[reading.sensor] = reading.raw;
  }
}

bool AgreeingVehicle::finished() const {
  const hooks::SbcView view = seat_.sbc();
  return view.known && view.phase == hooks::MissionPhase::Finished;
}

void AgreeingVehicle::cycle(double time) {
  // A vehicle that sent no report for a while has continued to count its cycles.
  state_.cycle = std::max(state_.cycle + 1, static_cast<uint32_t>(std::max(time, 0.0) / kCycle));
  state_.vehicle_time_s = time;
  state_.hook_state = hook_state_;
  state_.answer = sequence_ != 0 ? hooks::HookAnswer::Accepted : hooks::HookAnswer::None;
  state_.answered_sequence = sequence_;
  state_.session = hook_state_ == hooks::HookState::Active ? session_ : 0;
  const hooks::SeatVehicle vehicle{this, reading, write, [](void*, uint32_t, bool) {}};
  seat_.serve(time, state_, vehicle, sbc_line_.left());
  seat_.watch(state_);
  seat_.tick(state_, vehicle);
  seat_.finish(sbc_line_.left(), 0);
  for (int round = 0; round < kRounds; ++round) {
    exchange(time);
  }
  readings_.clear();
}

void AgreeingVehicle::exchange(double time) {
  carry(time);
  const hooks::SeatVehicle vehicle{this, reading, write, [](void*, uint32_t, bool) {}};
  seat_.serve(time, state_, vehicle, sbc_line_.left());
  seat_.watch(state_);
  seat_.finish(sbc_line_.left(), 0);
  passOverEvents();
}

/// What the seat has sent to the SBC, and its answer to the seat.
void AgreeingVehicle::carry(double time) {
  const GliderByteStream end = sbc_line_.right();
  std::array<uint8_t, hooks::MemoryLine::kCapacity> bytes;
  const int32_t count = end.read(end.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
  if (count > 0 && sbc_.alive()) {
    sbc_.deliver({bytes.data(), static_cast<size_t>(count)}, time);
    const std::vector<uint8_t> said = sbc_.collect();
    waiting_.insert(waiting_.end(), said.begin(), said.end());
  }
  if (!waiting_.empty()) {
    const int32_t taken =
        end.write(end.self, waiting_.data(), static_cast<uint32_t>(waiting_.size()));
    waiting_.erase(waiting_.begin(), waiting_.begin() + taken);
  }
}

/// The events of the seat are not needed here, but its queue is bounded and must be emptied.
void AgreeingVehicle::passOverEvents() {
  while (seat_.nextEvent().kind != hooks::SeatEvent::Kind::None) {
  }
}

bool AgreeingVehicle::reading(void* self, uint16_t id, double* value) {
  const auto& readings = static_cast<const AgreeingVehicle*>(self)->readings_;
  const auto found = readings.find(id);
  if (found != readings.end()) {
    *value = found->second;
  }
  return found != readings.end();
}

/// Accepts every instruction, and answers it in the next cycle.
void AgreeingVehicle::write(void* self, const hooks::SensorList* instruction) {
  auto& vehicle = *static_cast<AgreeingVehicle*>(self);
  for (uint32_t i = 0; i < instruction->count; ++i) {
    const hooks::SensorValue& word = instruction->values[i];
    if (word.id == vehicle.numbers_[Sensor::sci_hook_session]) {
      (void)hookIsWhole(word.value, 0, kHookMostSession, &vehicle.session_);
    } else if (word.id == vehicle.numbers_[Sensor::sci_hook_sequence]) {
      (void)hookIsWhole(word.value, 0, UINT16_MAX, &vehicle.sequence_);
    }
  }
}

}  // namespace glider::simulator
