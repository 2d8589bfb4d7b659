// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hookbeh.h"
#include "hooks/protocol/messages.h"
#include "tests/slocum.h"
#include "tests/unit/simulator/flights.h"
#include "vehicles/slocum/oracles/flight_judge.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::slocum::oracles {

inline constexpr double kCycle = 4;  // s

/// Shared: reading the platform file takes longer than a test.
inline const std::shared_ptr<const platforms::Dictionary>& slocumSensors() {
  static const auto sensors =
      std::make_shared<const platforms::Dictionary>(shippedSetup("default").platform);
  return sensors;
}

/// A FlightJudge and what it observes: what the SBC sends, what hookbeh does with it.
class Judged : public testing::Test {
 protected:
  explicit Judged(const JudgeSetup& judged = setup())
      : judge_(judged), array_(shippedSetup("default").platform) {
    array_.set(GLIDER_X_HOOK_GUARD, 0);
  }

  void say(hooks::Frame& frame) {
    frame.sequence = ++frame_sequence_;
    std::array<uint8_t, hooks::kMostEncodedBytes> bytes;
    judge_.said({bytes.data(), hooks::encodeFrame(frame, bytes.data())}, now_);
  }
  void instruct(uint32_t session, uint16_t sequence, hooks::HookControl control, double depth = 20,
                hooks::HookVertical vertical = hooks::HookVertical::Descend,
                double pitch = kPitch) {
    hooks::Frame frame;
    hooks::encodeEmptyList(frame);
    const std::pair<uint16_t, double> words[] = {
        {GLIDER_SCI_HOOK_SESSION, session},
        {GLIDER_SCI_HOOK_CONTROL, static_cast<double>(control)},
        {GLIDER_SCI_HOOK_VERTICAL, static_cast<double>(vertical)},
        {GLIDER_SCI_HOOK_DEPTH, depth},
        {GLIDER_SCI_HOOK_PITCH, pitch},
        {GLIDER_SCI_HOOK_LATERAL, 0},
        {GLIDER_SCI_HOOK_HEADING, 0},
        {GLIDER_SCI_HOOK_LAT, 0},
        {GLIDER_SCI_HOOK_LON, 0},
        {GLIDER_SCI_HOOK_CHECK, 7},
        {GLIDER_SCI_HOOK_SEQUENCE, sequence}};
    for (const auto& [id, value] : words) {
      ASSERT_TRUE(hooks::appendValue(frame, {id, value}));
      arriving_.emplace_back(id, value);
    }
    say(frame);
  }
  /// What was instructed gets into the sensor array.
  void arrive() {
    for (const auto& [id, value] : arriving_) {
      array_.set(id, value);
    }
    arriving_.clear();
  }
  void done(uint32_t session) {
    hooks::Frame frame;
    hooks::Done done;
    done.session = session;
    done.status.mission_time_s = now_;
    hooks::encode(done, frame);
    say(frame);
  }
  void obey(uint16_t sequence, uint32_t session = 1) {
    array_.set(GLIDER_X_HOOK_SESSION, session);
    array_.set(GLIDER_X_HOOK_SEQUENCE, sequence);
    array_.set(GLIDER_X_HOOK_ANSWER, static_cast<double>(hooks::HookAnswer::Accepted));
  }
  [[nodiscard]] uint8_t masked() const { return overridden_ ? hooks::kMaskedPump : uint8_t{0}; }
  bool cycle(hooks::HookState hook, double depth = 0.1, bool aborted = false) {
    now_ += kCycle;
    out_.commanding = hook == hooks::HookState::Active;
    array_.set(GLIDER_M_DEPTH, std::isnan(reading_) ? depth : reading_);
    array_.set(GLIDER_X_HOOK_GUARD, static_cast<double>(out_.guard));
    array_.set(GLIDER_SCI_HOOK_HEARTBEAT, beats_ ? ++heartbeat_ : heartbeat_);
    array_.set(GLIDER_C_BALLAST_PUMPED, overridden_ ? -out_.pump_cc : out_.pump_cc);
    return judge_.cycle({now_, hook, depth, aborted, ended_, array_, now_ - restarted_s_,
                         clearance_, used_J_, 14, whole_, aborted ? nullptr : &out_, masked()});
  }
  /// Up to `until_s` in control, the mission going on.
  void fly(double until_s) {
    while (now_ < until_s) {
      done(1);
      cycle(hooks::HookState::Active, 5 + 0.05 * now_);
    }
  }
  void take() {
    instruct(1, 1, hooks::HookControl::Take);
    arrive();
    obey(1);
    fly(40);
  }
  void giveBack() {
    instruct(1, 9, hooks::HookControl::Release);
    arrive();
    obey(9);
    cycle(hooks::HookState::Complete);
  }
  [[nodiscard]] std::string violation() const { return judge_.verdict().violation; }

  static JudgeSetup setup() {
    JudgeSetup setup;
    setup.faults.power = {{200, 400}};
    setup.promise = promiseOf(FaultKind::Power);
    setup.has_hookbeh = true;
    setup.args.greatest_depth_m = 60;
    setup.overdepth_m = 70;
    setup.undervolts = 10;
    setup.hull_m = 200;
    setup.pump_cc = hooks::kHull.pump_cc;
    setup.dictionary = slocumSensors();
    setup.mean_W = 3;
    return setup;
  }
  FlightJudge judge_;
  hooks::HookbehOutputs out_ = dives();
  static hooks::HookbehOutputs dives() {
    hooks::HookbehOutputs out;
    out.commanding = true;
    out.pitch_rad = kPitch;
    out.pump_cc = -230;
    return out;
  }
  void climb() {
    out_.pitch_rad = 0.4538;
    out_.pump_cc = 230;
  }
  double restarted_s_ = 0, clearance_ = 100, used_J_ = 0;
  double reading_ = std::nan("");  ///< of m_depth; NaN: the truth
  bool ended_ = false;             ///< the vehicle's mission is over
  bool whole_ = true;
  bool beats_ = true;        ///< a newer heartbeat comes in every cycle
  bool overridden_ = false;  ///< another behaviour has the pump
  double heartbeat_ = 0;
  static constexpr double kPitch = -0.5;
  SensorArray array_;
  double now_ = 0;
  uint8_t frame_sequence_ = 0;
  std::vector<std::pair<uint16_t, double>> arriving_;
};

}  // namespace glider::slocum::oracles
