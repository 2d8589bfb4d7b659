// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/handshake_judge.h"

#include <fmt/format.h>

namespace glider::slocum::oracles {

using hooks::HookState;

namespace {

constexpr int kAsksWithin = 3;   // cycles: an SBC that waits repeats its Take in each tick
constexpr double kSettled = 60;  // s after a fault

}  // namespace

HandshakeJudge::HandshakeJudge(const JudgeSetup& setup)
    : s_(setup), last_fault_s_(setup.faults.over()) {}

void HandshakeJudge::asked(double session, double sequence, double now_s) {
  session_ = session;
  sequence_ = sequence;
  asked_s_ = now_s;
}

bool HandshakeJudge::isAnswered(const CycleView& view) const {
  return view.array.get(Sensor::sci_hook_session) == session_ &&
         view.array.get(Sensor::x_hook_sequence) == sequence_ &&
         view.array.get(Sensor::x_hook_answer) != static_cast<double>(hooks::HookAnswer::BadCheck);
}

std::string HandshakeJudge::cycle(const CycleView& view) {
  const bool may_take = view.hook == HookState::Ready || view.hook == HookState::Silent;
  const bool asks = view.time_s - asked_s_ <= kAsksWithin * s_.cycle_s;
  const bool waits = may_take && asks && !view.aborted && view.time_s > last_fault_s_ + kSettled &&
                     !isAnswered(view);
  waits_since_s_ = !waits ? -1 : waits_since_s_ < 0 ? view.time_s : waits_since_s_;
  const double most = releaseSecs(Control::Unanswered, s_.controlTimes());
  return waits && view.time_s - waits_since_s_ > most
             ? fmt::format("the SBC asks for control for {:.0f} s and gets no answer",
                           view.time_s - waits_since_s_)
             : "";
}

}  // namespace glider::slocum::oracles
