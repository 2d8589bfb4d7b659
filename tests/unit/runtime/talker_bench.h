// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/tick.h"
#include "hooks/share/message.h"
#include "runtime/talk/talker.h"
#include "tests/unit/runtime/bench_mission.h"
#include "tests/unit/runtime/scripted_modem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace glider::runtime::testing {

using hooks::share::MessageWriter;
using talk::Talker;

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr uint32_t kDepth = 0, kUtc = 1, kPeerTop = 2, kPeerFound = 3;  // places
inline constexpr uint32_t kSecondTop = 4, kThirdTop = 5, kThirdFound = 6;
inline constexpr uint32_t kFound = 0;
inline constexpr double kSlot = 12, kCycle = 4;
inline constexpr double kMidnight =
    47222220.0 * 36;  // a slot of the first of three vehicles begins

inline GliderSensorInfo received(const char* name, uint32_t id, double highest) {
  return {name, gliderNothingHeard, 1, 0, highest, 600, id, kGliderLinear};
}

/// Depth every minute, with whether something was found; nothing else every ten.
inline GliderTalk benchTalk() {
  GliderTalk talk{};
  talk.slot_s = kSlot;
  talk.utc = kUtc;
  talk.begin_within_ms = 4000;
  talk.share_count = 3;
  talk.shares[0] = {0, 0.5, 401, kDepth, GLIDER_NO_PLACE, kPeerTop};
  talk.shares[1] = {0, 1, 2, GLIDER_NO_PLACE, kFound, kPeerFound};
  talk.shares[2] = {-100, 1, 1001, kDepth, GLIDER_NO_PLACE, GLIDER_NO_PLACE};
  talk.message_count = 2;
  talk.messages[0] = {60, 0, 2, 0xA5, 3};
  talk.messages[1] = {600, 2, 1, 0x5A, 3};
  talk.vehicle_count = 3;
  talk.named_count = 3;
  talk.named[0] = {kSecondTop, 0, 2};
  talk.named[1] = {kThirdTop, 0, 3};
  talk.named[2] = {kThirdFound, 1, 3};
  return talk;
}

/// A message as another vehicle sends it.
inline std::string hexOf(const GliderTalk& talk, uint32_t message,
                         const std::vector<double>& values) {
  MessageWriter writer;
  for (size_t i = values.size(); i != 0; --i) {
    const GliderShare& share = talk.shares[talk.messages[message].first + i - 1];
    writer.put({share.lowest, share.step, share.values}, values[i - 1]);
  }
  uint8_t bytes[32];
  EXPECT_TRUE(writer.end(static_cast<uint8_t>(talk.messages[message].signature), bytes,
                         talk.messages[message].bytes));
  std::string hex;
  for (uint32_t i = 0; i < talk.messages[message].bytes; ++i) {
    char two[3];
    std::snprintf(two, sizeof two, "%02X", bytes[i]);
    hex += two;
  }
  return hex;
}

/// A mission with shares, its vehicle by frames, and a modem.
class TalkerTest : public ::testing::Test {
 protected:
  TalkerTest() {
    mission_.sensors = {
        depthSensor(),
        {"m_present_time", nullptr, 1, 0, 4e9, 20, GLIDER_M_PRESENT_TIME, kGliderLinear},
        received("peer.top", 0xFE00, 200),
        received("peer.found", 0xFE01, 1),
        received("second.top", 0xFE20, 200),
        received("third.top", 0xFE21, 200),
        received("third.found", 0xFE22, 1)};
    mission_.states = {benchState("only", nullptr, 0)};
    mission_.variable_count = 1;
    mission_.finish(1);
    make(1, 3);
  }

  void make(uint32_t address, uint32_t vehicles) {
    talker_ = std::make_unique<Talker>(talk_, address, vehicles);
  }

  /// A tick of the mission with its frame, as the runtime does it.
  void tick() {
    std::vector<GliderUpdate> frame{update(GLIDER_M_DEPTH, depth_)};
    if (reports_utc_) {
      frame.push_back(update(GLIDER_M_PRESENT_TIME, utc() - report_is_late_));
    }
    auto count = static_cast<uint32_t>(frame.size());
    frame.resize(hooks::kMostSubscriptions);
    count = gliderHear(&mission_.mission, context_, &variation_, frame.data(), count);
    if (context_ == nullptr) {
      context_ =
          gliderStart(mission_.memory.data(), &mission_.mission, nullptr, frame.data(), count);
      began_ = now_;
    } else {
      gliderStep(context_, now_ - began_, frame.data(), count);
    }
  }
  /// So many seconds, with a tick every cycle.
  void run(double seconds) {
    for (const double end = now_ + seconds; now_ < end;) {
      now_ += 1;
      if (flies_ && std::fmod(now_, kCycle) == 0) {
        tick();
      }
      poll();
    }
  }
  void poll() {
    const size_t before = modem_.heard.size();
    talker_->poll(modem_.stream(), context_, now_ + clock_is_ahead_);
    for (size_t i = before; i < modem_.heard.size(); ++i) {
      said_at_.push_back(utc());
    }
  }
  [[nodiscard]] double utc() const { return kMidnight + now_ + utc_is_ahead_; }
  /// When the sentences that begin so were said.
  std::vector<double> timesOf(const std::string& name) {
    std::vector<double> times;
    for (size_t i = 0; i < said_at_.size(); ++i) {
      if (modem_.heard[i].starts_with(name)) {
        times.push_back(said_at_[i]);
      }
    }
    return times;
  }

  GliderTalk talk_ = benchTalk();
  BenchMission mission_;
  std::unique_ptr<Talker> talker_;
  ScriptedModem modem_;
  GliderContext* context_ = nullptr;
  double now_ = 0, began_ = 0, clock_is_ahead_ = 0, utc_is_ahead_ = 0, report_is_late_ = 0,
         depth_ = 7.3;
  double variation_ = kNan;
  bool flies_ = true, reports_utc_ = true;
  std::vector<double> said_at_;
};

}  // namespace glider::runtime::testing
