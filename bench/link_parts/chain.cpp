// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/link_parts/chain.h"

#include "tests/slocum.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::bench {
namespace {

constexpr double kCycle = 4;  // s, of the flight controller

}  // namespace

std::vector<double> Chain::latencies(size_t count) {
  constexpr double kStep = 0.25;
  for (double now = 0; latencies_.size() < count; now += kStep) {
    now_ = now;
    sbc_line_.setNow(now);
    line_.setNow(now);
    if (std::fmod(now, kCycle) == 0) {
      flightCycle();
    }
    if (std::fmod(now, 1) == 0) {
      maybeChange(isScienceSensor(watched_));
      while (const auto one = line_.to_science.next()) {
        memory_[one->id] = one->value;
        fresh_[one->id] = true;
      }
      hookprog_.run(now, {this, get, set}, science_side_.stream());
    }
    pollClient();
  }
  std::ranges::sort(latencies_);
  return latencies_;
}

double Chain::get(void* self, uint16_t id, bool* fresh) {
  auto& chain = *static_cast<Chain*>(self);
  *fresh = isScienceSensor(id) || std::exchange(chain.fresh_[id], false);
  return !isScienceSensor(id) ? chain.memory_[id] : id == chain.watched_ ? chain.value_ : 1;
}

void Chain::set(void* self, uint16_t id, double value) {
  static_cast<Chain*>(self)->line_.to_flight.send({.id = id, .value = value});
}

void Chain::maybeChange(bool its_time) {
  constexpr double kShare = 0.05;
  if (its_time && at_rest_ && state_ == HookState::Active && noise_.uniform() < kShare) {
    value_ = value_ == 10 ? 11 : 10;
    changed_at_ = now_;
    at_rest_ = false;
  }
}

void Chain::flightCycle() {
  ++cycle_;
  maybeChange(!isScienceSensor(watched_));
  while (const auto one = line_.to_flight.next()) {
    array_[one->id] = one->value;
  }
  const HookbehOutputs out = hookbeh_.cycle(inputs());
  state_ = out.state;
  const bool obeys = out.state == HookState::Active && out.answer == HookAnswer::Accepted &&
                     out.answered_sequence == array_[GLIDER_SCI_HOOK_SEQUENCE] &&
                     array_[GLIDER_SCI_HOOK_DEPTH] == depthFor(value_);
  if (!at_rest_ && obeys) {
    latencies_.push_back((now_ - changed_at_) / kCycle);
    at_rest_ = true;
  }
  report(out);
}

HookbehInputs Chain::inputs() const {
  const auto& a = array_;
  HookbehInputs in;
  in.time_s = now_;
  in.depth_m = 10;
  in.altitude_m = kNaN;
  in.heartbeat = a[GLIDER_SCI_HOOK_HEARTBEAT];
  in.words.session = a[GLIDER_SCI_HOOK_SESSION];
  in.words.sequence = a[GLIDER_SCI_HOOK_SEQUENCE];
  in.words.control = a[GLIDER_SCI_HOOK_CONTROL];
  in.words.vertical = a[GLIDER_SCI_HOOK_VERTICAL];
  in.words.lateral = a[GLIDER_SCI_HOOK_LATERAL];
  in.words.hook_depth_m = a[GLIDER_SCI_HOOK_DEPTH];
  in.words.hook_pitch_rad = a[GLIDER_SCI_HOOK_PITCH];
  in.words.hook_heading_rad = a[GLIDER_SCI_HOOK_HEADING];
  in.words.hook_latitude_ddmm = a[GLIDER_SCI_HOOK_LAT];
  in.words.hook_longitude_ddmm = a[GLIDER_SCI_HOOK_LON];
  in.words.check = a[GLIDER_SCI_HOOK_CHECK];
  return in;
}

void Chain::report(const HookbehOutputs& out) {
  for (uint16_t id = 0; id < GLIDER_SENSOR_COUNT; ++id) {
    if (!isScienceSensor(id)) {
      const double value = id == watched_                             ? value_
                           : id == GLIDER_M_PRESENT_SECS_INTO_MISSION ? now_
                           : id == GLIDER_X_HOOK_STATE    ? static_cast<double>(out.state)
                           : id == GLIDER_X_HOOK_ANSWER   ? static_cast<double>(out.answer)
                           : id == GLIDER_X_HOOK_SEQUENCE ? out.answered_sequence
                           : id == GLIDER_X_HOOK_SESSION  ? out.session
                                                          : cycle_;
      line_.to_science.send({.id = id, .value = value});
    }
  }
}

void Chain::pollClient() {
  const GliderByteStream end = sbc_side_.stream();
  for (ClientEvent event = ClientEvent::Handled; event != ClientEvent::Nothing;) {
    event = client_.poll(end, clockAt(now_));
    if (event == ClientEvent::Tick) {
      decide();
      client_.done({now_, 0, 0, MissionPhase::Flying}, end);
    }
  }
}

void Chain::decide() {
  const VehicleTick& tick = client_.tick();
  double value = known_;
  for (uint32_t i = 0; i < tick.reading_count; ++i) {
    value = tick.readings[i].id == watched_ ? tick.readings[i].value : value;
  }
  const bool take = !tick.obeys_us && tick.hook_state != HookState::Active && !taking_;
  taking_ = take || (taking_ && !tick.obeys_us && tick.hook_state != HookState::Silent);
  if (take || value != known_) {
    instruct(take ? HookControl::Take : HookControl::Steer, value);
  }
  known_ = value;
}

void Chain::instruct(HookControl control, double value) {
  Instruction instruction;
  instruction.control = control;
  instruction.vertical = HookVertical::Descend;
  instruction.depth_m = depthFor(value);
  instruction.pitch_rad = -0.4;
  client_.instruct(instruction);
}
}  // namespace glider::bench
