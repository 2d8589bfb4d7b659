// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/control.h"

#include "support/check.h"

#include <algorithm>

namespace glider::ir::prove {

bool Control::holds(StateId wanted) const {
  return state == wanted ||
         std::ranges::any_of(stack, [&](const Waiting& w) { return w.state == wanted; });
}

bool Control::mayInterrupt(const Mission& mission, uint32_t always_case) const {
  const Case& c = mission.always[always_case];
  return always_case < limit && !(c.target.valid() && holds(c.target));
}

Control Control::moved(ListKind list, uint32_t number, const Case& c) const {
  Control after = *this;
  after.just_returned = c.transition == Transition::Return;
  if (c.transition == Transition::Return) {
    CHECK(!stack.empty(), "a return with an empty stack");
    after.state = stack.back().state;
    after.limit = stack.back().limit;
    after.stack.pop_back();
    return after;
  }
  const uint32_t own = c.transition == Transition::Goto ? kNoLimit : limit;
  if (c.transition == Transition::Goto) {
    after.stack.clear();
  } else {
    after.stack.push_back({state, limit});
  }
  after.limit = list == ListKind::Always ? number : own;
  after.state = c.target;
  return after;
}

bool isNeverResumed(const Mission& mission, StateId state) {
  const auto calls = [](const Case& c) { return c.transition == Transition::Call; };
  return std::ranges::none_of(mission[state].cases, calls) &&
         std::ranges::none_of(mission.always, calls);
}

bool isEnteredOnlyAtStart(const Mission& mission, StateId state) {
  const auto enters = [&](const Case& c) { return c.target == state; };
  return state.index == 0 && std::ranges::none_of(mission.always, enters) &&
         std::ranges::none_of(mission.states, [&](const State& from) {
           return std::ranges::any_of(from.cases, enters);
         });
}

certify::Configuration configurationOf(const Control& control) {
  certify::Configuration at{control.state, {}, control.limit, control.just_returned};
  for (const Control::Waiting& waiting : control.stack) {
    at.stack.push_back({waiting.state, waiting.limit});
  }
  return at;
}

}  // namespace glider::ir::prove
