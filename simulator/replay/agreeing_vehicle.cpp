// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/replay/agreeing_vehicle.h"

#include "hooks/protocol/sensors.h"
#include "hooks/protocol/values.h"

#include <algorithm>
#include <array>
#include <limits>

namespace glider::simulator {
namespace {

constexpr double kCycle = 4;  // s
/// Rounds of questions and answers within one cycle.
constexpr int kRounds = 4;

}  // namespace

void AgreeingVehicle::floatAtSurface() {
  origin_s_ += kCycle;
  told_.push_back({numbers_[Sensor::m_depth], 0});
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
    if (hooks::isScienceSensor(dictionary_.get(), reading.sensor)) {
      science_[reading.sensor] = reading.raw;
    } else {
      told_.push_back({reading.sensor, reading.raw});
    }
  }
}

bool AgreeingVehicle::finished() const {
  const auto view = hookprog_.sbc();
  return view.known && view.phase == hooks::MissionPhase::Finished;
}

void AgreeingVehicle::cycle(double time) {
  report(time);
  for (int round = 0; round < kRounds; ++round) {
    exchange(time);
  }
  science_.clear();
}

/// Sends the array's sensors first; the time, which completes a cycle, comes last.
void AgreeingVehicle::report(double time) {
  // A vehicle that sent no report for a while has continued to count its cycles.
  cycles_ = std::max(cycles_ + 1, static_cast<uint32_t>(std::max(time, 0.0) / kCycle));
  const bool answers = sequence_ != 0;
  for (const hooks::SensorUpdate& update : std::initializer_list<hooks::SensorUpdate>{
           {numbers_[Sensor::x_hook_state], static_cast<double>(hook_state_)},
           {numbers_[Sensor::x_hook_answer],
            static_cast<double>(answers ? hooks::HookAnswer::Accepted : hooks::HookAnswer::None)},
           {numbers_[Sensor::x_hook_sequence], sequence_},
           {numbers_[Sensor::x_hook_session],
            hook_state_ == hooks::HookState::Active ? session_ : 0},
           {numbers_[Sensor::m_present_secs_into_mission], time},
           {numbers_[Sensor::m_cycle_number], static_cast<double>(cycles_)}}) {
    told_.push_back(update);
  }
  (void)flight_.send(told_.data(), static_cast<uint32_t>(told_.size()));
  told_.clear();
}

void AgreeingVehicle::exchange(double time) {
  hearInstructions();
  hookprog_.run(time, {this, ownSensor}, sbc_line_.left(), flight_science_link_.left());
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
  hookprog_.run(time, {this, ownSensor}, sbc_line_.left(), flight_science_link_.left());
  passOverEvents();
  hearInstructions();
}

/// Accepts every instruction, and answers it in the next cycle.
void AgreeingVehicle::hearInstructions() {
  std::array<hooks::SensorUpdate, 64> updates;
  for (uint32_t count = updates.size(); count == updates.size();) {
    count = flight_.poll(flight_science_link_.right(), updates.data(), updates.size());
    for (uint32_t i = 0; i < count; ++i) {
      if (updates[i].id == numbers_[Sensor::sci_hook_session]) {
        session_ = updates[i].value;
      } else if (updates[i].id == numbers_[Sensor::sci_hook_sequence]) {
        sequence_ = updates[i].value;
      }
    }
  }
}

/// The events of hookprog are not needed here, but its queue is bounded and must be emptied.
void AgreeingVehicle::passOverEvents() {
  while (hookprog_.nextEvent().kind != hooks::SeatEvent::Kind::None) {
  }
}

double AgreeingVehicle::ownSensor(void* self, uint16_t id, bool* fresh) {
  auto& vehicle = *static_cast<AgreeingVehicle*>(self);
  const auto found = vehicle.science_.find(id);
  *fresh = found != vehicle.science_.end();
  const double value = *fresh ? found->second : std::numeric_limits<double>::quiet_NaN();
  if (*fresh) {
    vehicle.science_.erase(found);
  }
  return value;
}

}  // namespace glider::simulator
