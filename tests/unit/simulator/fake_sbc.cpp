// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/simulator/fake_sbc.h"

#include "tests/slocum.h"

#include <utility>

namespace glider::simulator {
namespace {

constexpr hooks::Subscription kSensors[] = {
    {GLIDER_M_PRESENT_SECS_INTO_MISSION}, {GLIDER_M_DEPTH}, {GLIDER_SCI_WATER_TEMP}};

}  // namespace

FakePilot::FakePilot(Plan plan)
    : plan_(plan),
      client_(gliderDictionary,
              {.mission_name = "fake", .session = 1, .sensors = kSensors, .sensor_count = 3}) {}

void FakePilot::steer(double depth) {
  hooks::Instruction instruction;
  instruction.control = taken_ ? hooks::HookControl::Steer : hooks::HookControl::Take;
  instruction.vertical = plan_.hovers ? hooks::HookVertical::Hover
                         : diving_    ? hooks::HookVertical::Descend
                                      : hooks::HookVertical::Ascend;
  instruction.depth_m = depth;
  instruction.pitch_rad = diving_ ? -plan_.pitch_rad : plan_.pitch_rad;
  client_.instruct(instruction);
}

void FakePilot::tick(const GliderByteStream& stream) {
  ++ticks_;
  const hooks::VehicleTick& tick = client_.tick();
  for (uint32_t i = 0; i < tick.reading_count; ++i) {  // only what has changed
    depth_m_ = tick.readings[i].id == GLIDER_M_DEPTH ? tick.readings[i].value : depth_m_;
  }
  const double mission_time = taken_ ? tick.vehicle_time_s - start_s_ : 0;
  constexpr int kPatience = 6;  // ticks: the vehicle's answer to a handshake takes some
  const bool silent = tick.hook_state == hooks::HookState::Silent;
  if (silent && plan_.takes_again && !given_back_ && silent_ticks_++ % kPatience == 0) {
    start_s_ = taken_ ? start_s_ : tick.vehicle_time_s;
    taken_ = false;
    steer(diving_ ? plan_.bottom_m : plan_.top_m);
    taken_ = true;
  }
  if (!taken_ && tick.hook_state == hooks::HookState::Ready) {
    steer(plan_.bottom_m);
    taken_ = true;
    start_s_ = tick.vehicle_time_s;
  } else if (taken_ && !given_back_ && mission_time >= plan_.release_s) {
    hooks::Instruction instruction;
    instruction.control = hooks::HookControl::Release;
    client_.instruct(instruction);
    client_.notify({mission_time, 3, diving_ ? 0U : 1U, 0, 0});
    given_back_ = true;
  } else if (taken_ && !given_back_ && !plan_.hovers &&
             (diving_ ? depth_m_ >= plan_.bottom_m : depth_m_ <= plan_.top_m)) {
    diving_ = !diving_;
    steer(diving_ ? plan_.bottom_m : plan_.top_m);
    client_.notify({mission_time, 0, diving_ ? 1U : 0U, diving_ ? 0U : 1U, 0});
  }
  using hooks::MissionPhase;
  const auto phase = given_back_ ? MissionPhase::Finished
                     : taken_    ? MissionPhase::Flying
                                 : MissionPhase::Waiting;
  client_.done({mission_time, diving_ ? 0U : 1U, 0, phase}, stream);
}

void FakePilot::poll(const GliderByteStream& stream, const GliderClock& clock, int most_ticks) {
  while (ticks_ < most_ticks) {
    const hooks::ClientEvent event = client_.poll(stream, clock);
    if (event == hooks::ClientEvent::Tick) {
      tick(stream);
    } else if (event != hooks::ClientEvent::Handled && event != hooks::ClientEvent::SilentLink) {
      closed_ = event == hooks::ClientEvent::Closed;
      return;
    }
  }
}

int32_t FakeSbc::read(void* self, uint8_t* bytes, uint32_t capacity) {
  auto& in = static_cast<FakeSbc*>(self)->in_;
  if (!static_cast<FakeSbc*>(self)->plugged_) {
    return -1;
  }
  uint32_t count = 0;
  while (count < capacity && !in.empty()) {
    bytes[count++] = in.front();
    in.pop_front();
  }
  return static_cast<int32_t>(count);
}

int32_t FakeSbc::write(void* self, const uint8_t* bytes, uint32_t count) {
  auto& out = static_cast<FakeSbc*>(self)->out_;
  out.insert(out.end(), bytes, bytes + count);
  return static_cast<int32_t>(count);
}

void FakeSbc::deliver(std::span<const uint8_t> bytes, double now_s) {
  now_s_ = now_s;
  in_.insert(in_.end(), bytes.begin(), bytes.end());
}

std::vector<uint8_t> FakeSbc::collect() {
  if (now_s_ < silent_from_s_) {
    pilot_.poll({this, read, write}, {this, now});
  }
  return std::exchange(out_, {});
}

}  // namespace glider::simulator
