// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The bounds against the frames that hooks/protocol writes.

#include "ir/verify/link_bytes.h"

#include "hooks/protocol/messages.h"
#include "hooks/protocol/sensor_list.h"
#include "hooks/protocol/tick.h"
#include "tests/slocum.h"
#include "tests/unit/ir/slocum.h"

#include <gtest/gtest.h>

namespace glider::ir {
namespace {

/// The most that a frame of this payload takes: what COBS adds depends on the bytes.
uint64_t onTheLine(const hooks::Frame& frame) {
  uint8_t bytes[hooks::kMostEncodedBytes];
  EXPECT_LE(hooks::encodeFrame(frame, bytes), hooks::encodedBound(frame.size));
  return hooks::encodedBound(frame.size);
}

Mission subscribing(size_t count) {
  Mission mission;
  for (uint16_t id = 0; id < count; ++id) {
    Sensor sensor;
    sensor.id = id;
    mission.sensors.push_back(sensor);
  }
  return mission;
}

hooks::Subscribe subscriptionOf(const Mission& mission) {
  hooks::Subscribe subscribe;
  for (const Sensor& sensor : mission.sensors) {
    subscribe.sensors[subscribe.count++] = {sensor.id};
  }
  return subscribe;
}

/// A tick as hookprog sends it when all is new.
uint64_t tickBytes(const Mission& mission) {
  hooks::TickReadings readings;
  for (size_t i = 0; i < mission.sensors.size(); ++i) {
    readings.told[i] = hooks::ReadingReport::Value;
    readings.values[i] = 1.5;
  }
  hooks::Frame frame;
  hooks::encode(hooks::TickHead{}, subscriptionOf(mission), readings, frame);
  return onTheLine(frame);
}

TEST(LinkBytes, ATickIsWhatHookprogSends) {
  for (const size_t count : {size_t{0}, size_t{1}, size_t{5}, size_t{8}, size_t{9}, size_t{40},
                             slocum().sensors.size()}) {
    const Mission mission = subscribing(count);
    Mission with_depth = mission;
    if (count <= GLIDER_M_DEPTH) {  // the program subscribes to the depth too
      with_depth.sensors.push_back(subscribing(GLIDER_M_DEPTH + 1).sensors.back());
    }
    EXPECT_EQ(linkBytes(mission, slocum()).to_sbc, tickBytes(with_depth)) << count;
  }
}

TEST(LinkBytes, ASensorTwiceIsSubscribedOnce) {
  Mission mission = subscribing(3);
  const uint64_t before = linkBytes(mission, slocum()).to_sbc;
  mission.sensors.push_back(mission.sensors[0]);
  EXPECT_EQ(linkBytes(mission, slocum()).to_sbc, before);
}

TEST(LinkBytes, AnAnswerHoldsAllThatCanBeSaid) {
  Mission mission = subscribing(4);
  hooks::Frame frame;
  uint64_t bytes = 0;
  hooks::encode(subscriptionOf(mission), frame);
  bytes += onTheLine(frame);
  hooks::encode(hooks::TransitionNotice{}, frame);
  bytes += 8 * onTheLine(frame);  // Client::kMostNotices
  uint64_t instruction = 0;
  hooks::encodeEmptyList(frame);
  for (const platforms::PlatformSensor& sensor : slocum().sensors) {
    if (hooks::isInstructionSensor(sensor.id)) {
      EXPECT_TRUE(hooks::appendValue(frame, {sensor.id, 1}));
    }
  }
  instruction = onTheLine(frame);
  hooks::encode(hooks::Done{}, frame);
  bytes += instruction + onTheLine(frame);
  EXPECT_EQ(linkBytes(mission, slocum()).from_sbc, bytes);
  // A `log` statement adds the most notes of an answer, Client::kMostNotes.
  Statement log;
  log.kind = StatementKind::Log;
  mission.blocks.push_back({{log}});
  hooks::MissionNote note;
  for (uint32_t i = 0; i < hooks::kMostNoteBytes; ++i) {
    note.text[i] = 'x';
  }
  hooks::encode(note, frame);
  EXPECT_EQ(linkBytes(mission, slocum()).from_sbc, bytes + 8 * onTheLine(frame));
}

}  // namespace
}  // namespace glider::ir
