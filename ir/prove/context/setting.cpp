// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/setting.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"

#include <algorithm>

namespace glider::ir::prove {
namespace {

/// The variables that some blocks set.
class Marks {
 public:
  explicit Marks(const Mission& mission) : m_(mission), set_(mission.variables.size(), false) {}

  void block(BlockId block) {
    forEachStatement(m_, block, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Set) {
        set_[statement.variable.index] = true;
      }
    });
  }

  /// Another list is tried only after `stay` and `done`.
  void staying(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      if (staysIn(c.transition)) {
        block(c.action);
      }
    }
  }

  void all(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      block(c.action);
    }
  }

  void done(const Activity& activity) {
    if (activity.done.valid()) {
      set_[activity.done.index] = true;
    }
  }

  [[nodiscard]] const std::vector<bool>& set() const { return set_; }

 private:
  const Mission& m_;
  std::vector<bool> set_;
};

std::vector<VariableId> readBy(const Mission& m, const Temporal& temporal) {
  std::vector<VariableId> read;
  const auto gather = [&](const Expr& e) {
    if (e.op == Op::Variable) {
      read.push_back(e.variable);
    }
  };
  forEachIn(m, temporal.operand, gather);
  if (temporal.duration.valid()) {
    forEachIn(m, temporal.duration, gather);
  }
  return read;
}

/// The variables that may be set before the list of a state's temporal is tried.
Marks setBefore(const Mission& m, const Temporal& temporal, const Marks& by_always) {
  Marks before = by_always;
  const State& state = m[temporal.state];
  if (temporal.list == ListKind::Profile || temporal.list == ListKind::Route) {
    before.staying(state.cases);
  }
  if (temporal.list == ListKind::Route) {
    before.staying(state.profile.cases);
    before.done(state.profile);
  }
  return before;
}

bool calls(const std::vector<Case>& cases) {
  return std::ranges::any_of(cases, [](const Case& c) { return c.transition == Transition::Call; });
}

}  // namespace

std::vector<std::vector<VariableId>> setSinceWatched(const Mission& mission) {
  Marks by_always(mission);
  by_always.staying(mission.always);
  // On the tick after a `return` the state's own list comes before `always`, for any list.
  Marks by_states(mission);
  for (const State& state : mission.states) {
    by_states.staying(state.cases);
  }
  std::vector<std::vector<VariableId>> all;
  for (const Temporal& temporal : mission.temporals) {
    std::vector<VariableId> read;
    if (!isWindow(temporal.kind)) {
      read = readBy(mission, temporal);
    }
    if (!read.empty()) {
      const Marks before =
          temporal.list == ListKind::Always ? by_states : setBefore(mission, temporal, by_always);
      std::erase_if(read, [&](VariableId id) { return !before.set()[id.index]; });
    }
    all.push_back(std::move(read));
  }
  return all;
}

std::vector<bool> setWhileCurrent(const Mission& mission, const State& state) {
  Marks marks(mission);
  if (calls(state.cases) || calls(mission.always)) {
    for (uint32_t i = 0; i < mission.blocks.size(); ++i) {
      marks.block({i});
    }
  }
  marks.all(mission.always);
  marks.all(state.cases);
  for (const Activity* activity : {&state.profile, &state.route}) {
    marks.block(activity->entry);
    marks.all(activity->cases);
    marks.done(*activity);
  }
  return marks.set();
}

}  // namespace glider::ir::prove
