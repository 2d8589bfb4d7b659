// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/evidence/configurations.h"

#include "ir/verify/structure.h"

#include <set>
#include <utility>

namespace glider::ir::prove {
namespace {

class Exploration {
 public:
  Exploration(const Mission& mission, StateId after)
      : m_(mission), structure_(mission), after_(after) {}

  std::optional<std::vector<Reached>> run(size_t most) {
    Control start;
    start.state = {0};
    reach({start, after_ == StateId{0}});
    while (!pending_.empty()) {
      if (seen_.size() > most) {
        return std::nullopt;
      }
      const Reached from = pending_.back();
      pending_.pop_back();
      if (from.control.just_returned) {  // until the next tick
        Reached later = from;
        later.control.just_returned = false;
        reach(later);
      }
      follow(from, ListKind::Always, m_.always, structure_.always.dead);
      follow(from, ListKind::State, m_[from.control.state].cases,
             structure_.moves[from.control.state.index].dead);
    }
    return std::vector<Reached>(seen_.begin(), seen_.end());
  }

 private:
  void follow(const Reached& from, ListKind list, const std::vector<Case>& cases,
              const std::vector<Dead>& dead) {
    for (uint32_t i = 0; i < cases.size(); ++i) {
      const Case& c = cases[i];
      const bool leaves = c.transition == Transition::Goto || c.transition == Transition::Call ||
                          c.transition == Transition::Return;
      const bool may =
          dead[i] == Dead::No && (list != ListKind::Always || from.control.mayInterrupt(m_, i));
      if (leaves && may) {
        const bool enters = c.transition != Transition::Return && c.target == after_;
        reach({from.control.moved(list, i, c), from.after || enters});
      }
    }
  }

  void reach(Reached seen) {
    if (seen_.insert(seen).second) {
      pending_.push_back(std::move(seen));
    }
  }

  const Mission& m_;
  Structure structure_;
  StateId after_;
  std::set<Reached> seen_;
  std::vector<Reached> pending_;
};

}  // namespace

std::optional<std::vector<Reached>> configurations(const Mission& mission, StateId after) {
  constexpr size_t kMost = 5000;
  return Exploration(mission, after).run(kMost);
}

}  // namespace glider::ir::prove
