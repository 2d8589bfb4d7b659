// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/line_ends.h"

#include <gtest/gtest.h>

#include <vector>

namespace glider::hooks {

/// A client whose vehicle is the test.
class ClientTest : public testing::Test {
 protected:
  ClientTest() : client_(gliderDictionary, options()) {}

  static ClientOptions options() {
    static const Subscription sensors[] = {{GLIDER_M_DEPTH}, {GLIDER_SCI_WATER_TEMP, 2, 0.5F}};
    ClientOptions options;
    options.mission_name = "survey";
    options.session = 5;
    options.sensors = sensors;
    options.sensor_count = 2;
    return options;
  }

  ClientEvent poll() { return client_.poll(sbc_, clock_.clock()); }
  std::vector<Frame> answers() { return framesAt(vehicle_); }

  static Subscribe subscription() { return {2, {options().sensors[0], options().sensors[1]}}; }

  template <typename Message>
  void say(const Message& message) {
    putMessage(vehicle_, message, ++said_);
  }

  void beacon() { say(Beacon{kProtocolVersion, {}, gliderDictionary.hash, HookState::Ready}); }

  Hello link() {
    beacon();
    EXPECT_EQ(poll(), ClientEvent::Handled);
    const auto frames = answers();
    Hello hello;
    EXPECT_TRUE(decode(frames.at(0), hello));
    head_.link = hello.link;
    head_.subscription = subscriptionCheck(subscription());
    head_.hook_state = HookState::Ready;
    return hello;
  }

  void sayTick(const TickReadings& readings = {}) {
    Frame frame;
    encode(head_, subscription(), readings, frame);
    frame.sequence = ++said_;
    put(vehicle_, frame);
  }

  /// One cycle of the vehicle; returns the frames of the answer.
  std::vector<Frame> tick(const TickReadings& readings = {}) {
    ++head_.cycle;
    sayTick(readings);
    EXPECT_EQ(poll(), ClientEvent::Tick);
    client_.done({}, sbc_);
    return answers();
  }

  static SensorList written(const Frame& frame) {
    SensorList list;
    EXPECT_TRUE(decodeList(frame, list));
    return list;
  }

  static Instruction descend(HookControl control) {
    Instruction instruction;
    instruction.control = control;
    instruction.vertical = HookVertical::Descend;
    instruction.depth_m = 20.1;
    instruction.pitch_rad = -0.4;
    return instruction;
  }

  MemoryLine line_;
  GliderByteStream vehicle_ = line_.left();
  GliderByteStream sbc_ = line_.right();
  HandClock clock_;
  Client client_;
  TickHead head_;
  uint8_t said_ = 0;
};

}  // namespace glider::hooks
