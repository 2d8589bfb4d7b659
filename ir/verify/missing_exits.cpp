// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <utility>

namespace glider::ir {
namespace {

/// The transitions that go to or call a state.
struct Users {
  std::vector<std::vector<Edge>> all;
  explicit Users(const Structure& structure) : all(structure.size()) {
    for (uint32_t s : structure.order) {
      for (const Edge& edge : structure.moves[s].edges) {
        all[edge.to].push_back(edge);
      }
    }
  }
};

/// For each state the smallest limit with which a trace in that state can end without a return
/// below where it began: by an `exit`, or by an error that has its own report (a state nothing
/// leaves, a return with an empty stack). What a call leads to is counted; that it may return gains
/// nothing, because the caller's own cases are counted anyway. That a case of `always` may not fire
/// because its target is on the stack is ignored: at worst a warning is missing.
///
/// A state whose own cases lead to an end needs no limit. Any other ends by way of `always`: of its
/// first case that leads to an end. That this case does not interrupt the state that is its target
/// changes nothing: the first case's target needs no limit itself, ends by an earlier `exit` of
/// `always`, or returns, about which nothing is reported.
class Ends {
 public:
  Ends(const Structure& structure, const Users& users)
      : s_(structure), users_(users), needs_none_(s_.size()), ends_(s_.size()) {
    by_exit_ = s_.always.exit_case ? *s_.always.exit_case + uint64_t{1} : kNever;
    for (uint32_t state : s_.order) {
      const bool returns = std::ranges::any_of(
          s_.moves[state].edges, [&](const Edge& edge) { return goesToReturn(edge); });
      if (s_.moves[state].exit_case || s_.deadEnd(state) || returns) {
        needsNone(state);
      }
    }
    do {
      spread();
    } while (interrupt());
  }

  [[nodiscard]] bool canEnd(uint32_t state, uint32_t limit) const { return needed(state) <= limit; }

 private:
  static constexpr uint64_t kNever = UINT64_MAX;

  /// Whether a `goto` to the state makes its return meet an empty stack.
  [[nodiscard]] bool goesToReturn(const Edge& edge) const {
    return !edge.call && s_.moves[edge.to].return_case;
  }

  [[nodiscard]] uint64_t needed(uint32_t state) const {
    return needs_none_[state] ? 0 : std::min(by_exit_, by_interrupt_);
  }

  void needsNone(uint32_t state) {
    if (!needs_none_[state]) {
      needs_none_[state] = true;
      pending_.push_back(state);
    }
  }

  /// A state that goes to or calls a state that needs no limit needs none either.
  void spread() {
    while (!pending_.empty()) {
      const uint32_t state = pending_.front();
      pending_.pop_front();
      for (const Edge& edge : users_.all[state]) {
        needsNone(edge.from);
      }
    }
  }

  /// Looks for the first case of `always` that leads to an end, and for states that go to one that
  /// now can end: they need no limit. Returns whether there was any.
  bool interrupt() {
    const auto leads_to_end = [&](const Edge& edge) {
      return goesToReturn(edge) || canEnd(edge.to, edge.case_index);
    };
    const auto first = std::ranges::find_if(s_.always.edges, leads_to_end);
    const uint64_t limit =
        first == s_.always.edges.end() ? kNever : first->case_index + uint64_t{1};
    bool any = limit != std::exchange(by_interrupt_, limit);
    for (uint32_t state : s_.order) {
      if (!ends_[state] && needed(state) != kNever) {
        ends_[state] = any = true;
        for (const Edge& edge : users_.all[state]) {
          if (!edge.call) {
            needsNone(edge.from);
          }
        }
      }
    }
    return any;
  }

  const Structure& s_;
  const Users& users_;
  std::vector<bool> needs_none_;
  std::vector<bool> ends_;          ///< with the greatest limit at least
  uint64_t by_exit_ = kNever;       ///< limit with which the `exit` of `always` may fire
  uint64_t by_interrupt_ = kNever;  ///< limit with which its first other case to an end may fire
  std::deque<uint32_t> pending_;
};

void noteExits(support::DiagnosticBuilder& report, const std::vector<Case>& cases,
               const Moves& moves, const std::string& nowhere) {
  for (uint32_t c = 0; c < cases.size(); ++c) {
    if (cases[c].transition != Transition::Exit) {
      continue;
    }
    if (moves.dead[c] != Dead::No) {
      noteDeadCase(report, cases[c], moves.dead[c], nowhere.empty() ? "`always`" : "the state");
    } else {
      report.note(cases[c].range, nowhere);
    }
  }
}

void reportWholeMission(Verification& v) {
  const Mission& m = v.structure.mission;
  auto report =
      v.diagnostics.report(support::diagnostics::missionWithoutEnd, m.states.front().range);
  noteExits(report, m.always, v.structure.always, "");
  for (uint32_t s = 0; s < v.structure.size(); ++s) {
    noteExits(
        report, m.states[s].cases, v.structure.moves[s],
        fmt::format("this `exit` does not count: state `{}` is unreachable", m.states[s].name));
  }
}

/// States that belong together get one report, at the one nearest to the start.
void reportStates(Verification& v, const std::vector<bool>& endless) {
  constexpr size_t kMost = 8;
  const Mission& m = v.structure.mission;
  const Users users(v.structure);
  std::vector<bool> told(v.structure.size());
  for (uint32_t first : v.structure.order) {
    // States that return are endless only in traces that an endless state began: they are reported
    // with it.
    if (!endless[first] || told[first] || v.structure.moves[first].return_case) {
      continue;
    }
    told[first] = true;
    std::vector<uint32_t> group = {first};
    for (size_t i = 0; i < group.size(); ++i) {
      auto join = [&](uint32_t state) {
        if (endless[state] && !told[state]) {
          told[state] = true;
          group.push_back(state);
        }
      };
      std::ranges::for_each(v.structure.moves[group[i]].edges, join, &Edge::to);
      std::ranges::for_each(users.all[group[i]], join, &Edge::from);
    }
    const State& state = m.states[first];
    auto report = v.diagnostics.report(support::diagnostics::noWayToExit, state.range, state.name);
    notePath(report, v.structure, v.structure.pathTo(v.structure.nearest(first)));
    for (size_t i = 1; i < group.size() && i <= kMost; ++i) {
      const State& other = m.states[group[i]];
      report.note(other.range, fmt::format("state `{}` cannot reach an `exit` either", other.name));
    }
  }
}

}  // namespace

std::vector<bool> statesWithoutEnd(const Structure& structure) {
  const Users users(structure);
  const Ends ends(structure, users);
  std::vector<bool> endless(structure.size());
  std::deque<uint32_t> pending;
  for (uint32_t s : structure.order) {
    // A state that returns continues in its caller, or is an error of its own.
    if (!ends.canEnd(s, structure.lowestLimit(s)) && !structure.moves[s].return_case) {
      endless[s] = true;
      pending.push_back(s);
    }
  }
  // What an endless state calls may return, but only to it.
  while (!pending.empty()) {
    const uint32_t state = pending.front();
    pending.pop_front();
    for (const Edge& edge : structure.moves[state].edges) {
      if (edge.call && !endless[edge.to]) {
        endless[edge.to] = true;  // if it could reach an end, its caller could also
        pending.push_back(edge.to);
      }
    }
  }
  return endless;
}

void passes::missingExits(Verification& v) {
  const Structure& s = v.structure;
  auto exits = [&](uint32_t state) { return s.moves[state].exit_case.has_value(); };
  if (!s.always.exit_case && std::ranges::none_of(s.order, exits)) {
    reportWholeMission(v);
    return;
  }
  reportStates(v, statesWithoutEnd(s));
}

}  // namespace glider::ir
