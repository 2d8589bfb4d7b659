// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/entered_after.h"

#include <vector>

namespace glider::ir::prove {
namespace {

class AfterSearch {
 public:
  explicit AfterSearch(const Mission& mission) : m_(mission), seen_(mission.states.size()) {}

  bool run(StateId wanted, StateId after) {
    reach(after);
    while (!open_.empty() && !entered_) {
      const StateId current = open_.back();
      open_.pop_back();
      follow(m_.always, wanted);
      follow(m_[current].cases, wanted);
    }
    return entered_;
  }

 private:
  void reach(StateId state) {
    if (!seen_[state.index]) {
      seen_[state.index] = true;
      open_.push_back(state);
    }
  }

  void follow(const std::vector<Case>& cases, StateId wanted) {
    for (const Case& c : cases) {
      if (c.transition == Transition::Goto || c.transition == Transition::Call) {
        entered_ = entered_ || c.target == wanted;
        reach(c.target);
      } else if (c.transition == Transition::Return) {
        reachCallers();
      }
    }
  }

  /// Every caller may be resumed; for a call of `always`, any state.
  void reachCallers() {
    const auto calls = [](const std::vector<Case>& cases) {
      for (const Case& c : cases) {
        if (c.transition == Transition::Call) {
          return true;
        }
      }
      return false;
    };
    const bool always = calls(m_.always);
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      if (always || calls(m_.states[i].cases)) {
        reach({i});
      }
    }
  }

  const Mission& m_;
  std::vector<bool> seen_;
  std::vector<StateId> open_;
  bool entered_ = false;
};

}  // namespace

bool mayEnterAfter(const Mission& mission, StateId state, StateId after) {
  return AfterSearch(mission).run(state, after);
}

}  // namespace glider::ir::prove
