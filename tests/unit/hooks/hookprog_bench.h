// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookprog/hookprog.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/line_ends.h"
#include "tests/unit/hooks/vehicle_line.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <vector>

namespace glider::hooks {

/// A hookprog whose flight controller, instruments and SBC are the test.
class HookprogBench : public testing::Test {
 protected:
  HookprogBench() : hookprog_(gliderDictionary, SeatOptions{true}) {}

  void run(double seconds = 1) {
    now_ += seconds;
    const auto own = [this](uint16_t id, bool* fresh) {
      const auto found = science_.find(id);
      *fresh = found != science_.end();
      const double value = *fresh ? found->second : 0;
      science_.erase(id);
      return value;
    };
    hookprog_.run(now_, line_.memory(own), sbc_line_.left());
  }

  /// The flight controller reports `values`, time and cycle; nothing more of it comes.
  void cycle(std::vector<SensorUpdate> values = {}) {
    ++cycle_;
    values.push_back({GLIDER_M_PRESENT_SECS_INTO_MISSION, 4.0 * cycle_});
    values.push_back({GLIDER_M_CYCLE_NUMBER, cycle_});
    line_.fromFlight(values);
    run(0);
    run();
  }

  std::vector<SensorUpdate> atFlight() { return line_.atFlight(); }

  /// The last value that has come to the flight controller since the last call; NaN: none.
  double newestAtFlight(uint16_t id) {
    double newest = std::numeric_limits<double>::quiet_NaN();
    for (const SensorUpdate& update : atFlight()) {
      newest = update.id == id ? update.value : newest;
    }
    return newest;
  }

  std::vector<Frame> atSbc() { return framesAt(sbc_line_.right()); }

  template <typename Message>
  void say(const Message& message) {
    putMessage(sbc_line_.right(), message, ++said_);
  }

  void hello(uint32_t link = 7) {
    Hello hello;
    hello.dictionary = gliderDictionary.hash;
    hello.link = link;
    hello.mission_name[0] = 'm';
    say(hello);
    say(subscription());
    say(answered());
    run();
  }

  static Subscribe subscription() {
    return {3, {{GLIDER_M_DEPTH}, {GLIDER_SCI_WATER_TEMP}, {GLIDER_M_PITCH}}};
  }

  /// The newest Tick, which must be there.
  TickReadings tick(const Subscribe& subscribed, TickHead* head = nullptr) {
    const auto frames = atSbc();
    TickHead unused;
    TickReadings readings;
    EXPECT_EQ(frames.size(), 1U);
    EXPECT_TRUE(decode(frames.at(0), head == nullptr ? unused : *head));
    EXPECT_TRUE(decode(frames.at(0), subscribed, readings));
    tick_sequence_ = frames.at(0).sequence;
    return readings;
  }

  /// The SBC answers the newest Tick that tick() has seen.
  void answerTick() {
    say(Done{tick_sequence_, 0, {now_, 0, 0, MissionPhase::Flying}});
    run();
  }

  static Done answered(uint32_t session = 0, double time = 1) {
    return {1, session, {time, 2, 1, MissionPhase::Flying}};
  }

  void write(const std::vector<SensorValue>& values) {
    Frame frame;
    encodeEmptyList(frame);
    for (const auto& value : values) {
      ASSERT_TRUE(appendValue(frame, value));
    }
    frame.sequence = ++said_;
    put(sbc_line_.right(), frame);
  }

  std::vector<SeatEvent::Kind> events() {
    std::vector<SeatEvent::Kind> kinds;
    for (auto event = hookprog_.nextEvent(); event.kind != SeatEvent::Kind::None;
         event = hookprog_.nextEvent()) {
      kinds.push_back(event.kind);
      last_event_ = event;
    }
    return kinds;
  }

  MemoryLine sbc_line_;
  VehicleLine line_;
  Hookprog hookprog_;
  std::map<uint16_t, double> science_;
  double now_ = 0;
  double cycle_ = 0;
  uint8_t said_ = 0;
  uint8_t tick_sequence_ = 0;
  SeatEvent last_event_;
};

}  // namespace glider::hooks
