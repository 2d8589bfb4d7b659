// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hull.h"
#include "tests/unit/slocum/judged.h"

#include <functional>
#include <optional>

namespace glider::slocum::oracles {

using hooks::HookGuard;
using hooks::HookState;

/// A vehicle that flies yos as commanded, until a loss is planted in it.
class GoodFlight {
 public:
  explicit GoodFlight(JudgeSetup setup = usual())
      : setup_(std::move(setup)), judge_(setup_), array_(shippedSetup("default").platform) {
    array_.set(GLIDER_X_HOOK_GUARD, 0);
    array_.set(GLIDER_X_HOOK_MASKED, 0);
  }

  static JudgeSetup usual() {
    JudgeSetup setup;
    // As under sensors that are wrong: whether instructions are followed is not checked.
    setup.promise = promiseOf(FaultKind::SensorStuck);
    setup.has_hookbeh = true;
    setup.args.greatest_depth_m = 60;
    setup.args.least_altitude_m = 5;
    setup.overdepth_m = 70;
    setup.undervolts = 10;
    setup.hull_m = 200;
    setup.pump_cc = hooks::kHull.pump_cc;
    setup.pump_out_j_cc = 0.29;
    setup.pump_out_j_cc_m = 0.018;
    setup.loads_W = 1.6;
    setup.through_water_mps = 0.6;
    setup.dictionary = slocumSensors();
    setup.mean_W = 3;
    return setup;
  }

  void say(hooks::Frame& frame) {
    frame.sequence = ++frames_;
    std::array<uint8_t, hooks::kMostEncodedBytes> bytes;
    judge_.said({bytes.data(), hooks::encodeFrame(frame, bytes.data())}, now_);
  }
  void instruct(uint32_t session, uint16_t sequence, hooks::HookControl control,
                hooks::HookVertical vertical, double depth, bool arrives = true) {
    hooks::Frame frame;
    hooks::encodeEmptyList(frame);
    const double pitch = vertical == hooks::HookVertical::Ascend ? 0.4538 : -0.4538;
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
      if (arrives) {
        array_.set(id, value);
      }
    }
    say(frame);
    if (arrives) {
      array_.set(GLIDER_X_HOOK_SESSION, session);
      array_.set(GLIDER_X_HOOK_SEQUENCE, sequence);
      array_.set(GLIDER_X_HOOK_ANSWER, static_cast<double>(hooks::HookAnswer::Accepted));
      newest_ = sequence;
    }
  }
  void take() {
    instruct(1, 1, hooks::HookControl::Take, hooks::HookVertical::Descend, 40);
    state_ = HookState::Active;
  }
  void steer(hooks::HookVertical vertical, double depth) {
    instruct(1, static_cast<uint16_t>(newest_ + 1), hooks::HookControl::Steer, vertical, depth);
  }
  /// One cycle of a flight between 4 and 40 m.
  void cycle() {
    now_ += kCycle;
    follow();
    tamper_(*this);
    const hooks::HookbehOutputs* hookbeh = aborted_ ? nullptr : &out_;
    out_.commanding = state_ == HookState::Active;
    array_.set(GLIDER_M_DEPTH, reading_ ? *reading_ : depth_);
    array_.set(GLIDER_X_HOOK_GUARD,
               reported_guard_ ? *reported_guard_ : static_cast<double>(out_.guard));
    array_.set(GLIDER_SCI_HOOK_HEARTBEAT, beats_ ? ++heartbeat_ : heartbeat_);
    array_.set(GLIDER_C_BALLAST_PUMPED, out_.pump_cc);
    array_.set(Sensor::c_pitch, out_.pitch_rad);
    if (talks_) {
      hooks::Frame frame;
      hooks::Done done;
      done.session = 1;
      done.status.mission_time_s = now_;
      hooks::encode(done, frame);
      say(frame);
    }
    used_J_ += power_W_ * kCycle;
    CycleView view{now_, state_,     depth_,  aborted_, ended_, array_,
                   now_, clearance_, used_J_, volts_,   true,   hookbeh};
    view.east_m = east_m_;
    view.pumped_cc = pumped_cc_;
    view.left_J = left_J_;
    judge_.cycle(view);
  }
  void fly(double seconds) {
    for (const double until_s = now_ + seconds; now_ < until_s;) {
      cycle();
    }
  }
  /// The same with `tamper` in each cycle.
  void fly(double seconds, const std::function<void(GoodFlight&)>& tamper) {
    tamper_ = tamper;
    fly(seconds);
    tamper_ = [](GoodFlight&) {};
  }
  void release() {
    instruct(1, static_cast<uint16_t>(newest_ + 1), hooks::HookControl::Release,
             hooks::HookVertical::None, 0);
    state_ = HookState::Complete;
  }
  /// Comes up and exits: the end of a good flight.
  void land() {
    if (state_ == HookState::Active) {
      release();
    }
    goal_m_ = 0;
    fly(60 + depth_ / 0.19);
  }
  [[nodiscard]] Verdict verdict() const { return judge_.verdict(); }

  // What a loss is planted in.
  double depth_ = 0.5, clearance_ = 100, power_W_ = 3, used_J_ = 0, volts_ = 14, left_J_ = 8e6;
  double east_m_ = 0, mps_ = 0.3, pumped_cc_ = 233;
  std::optional<double> reading_, reported_guard_, goal_m_, held_m_;
  bool beats_ = true, talks_ = true, aborted_ = false, ended_ = false, lands_ = true;
  bool guarded_ = false;
  std::function<void(GoodFlight&)> tamper_ = [](GoodFlight&) {
  };  ///< in each cycle, before it is seen
  HookState state_ = HookState::Ready;
  hooks::HookbehOutputs out_;
  double now_ = 0;

 private:
  /// Moves the vehicle, and commands what brings it there.
  void follow() {
    constexpr double kMps = 0.19;
    if (!goal_m_ && !guarded_ && ((down_ && depth_ >= 40) || (!down_ && depth_ <= 4))) {
      down_ = !down_;
      if (state_ == HookState::Active) {
        steer(down_ ? hooks::HookVertical::Descend : hooks::HookVertical::Ascend, down_ ? 40 : 4);
      }
    }
    const bool down = goal_m_ ? depth_ < *goal_m_ : down_ && !guarded_;
    const double left = goal_m_ ? std::fabs(depth_ - *goal_m_) : 1e9;
    depth_ += (down ? 1 : -1) * std::min(kMps * kCycle, left);
    depth_ = held_m_ ? *held_m_ : std::max(depth_, 0.5);
    east_m_ += mps_ * (state_ == HookState::Active ? kCycle : 0);
    out_.guard = guarded_ ? HookGuard::NoDepthGained : HookGuard::None;
    out_.doing = guarded_ ? hooks::Doing::NoDepthGained
                 : down   ? hooks::Doing::DiveTo
                          : hooks::Doing::ClimbTo;
    out_.pitch_rad = down ? -0.4538 : 0.4538;
    out_.pump_cc = down ? -230 : guarded_ ? hooks::kHull.pump_cc : 230;
    pumped_cc_ = out_.pump_cc;
  }

  JudgeSetup setup_;
  FlightJudge judge_;
  SensorArray array_;
  bool down_ = true;
  double heartbeat_ = 0;
  uint16_t newest_ = 0;
  uint8_t frames_ = 0;
};

}  // namespace glider::slocum::oracles
