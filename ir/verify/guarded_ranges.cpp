// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/guarded_ranges.h"

#include "ir/verify/narrowed.h"

#include <algorithm>
#include <span>

namespace glider::ir {
namespace {

/// Follows every list of cases and every block with the knowledge from conditions there.
class GuardedWalk {
 public:
  GuardedWalk(const Mission& mission, const std::vector<Interval>& intervals,
              const std::set<AssignmentPlace>& doubtful)
      : m_(mission), doubtful_(doubtful), narrowing_(mission, intervals) {}

  void run() {
    list(m_.always, true);
    for (const State& state : m_.states) {
      list(state.cases, false);
      list(state.profile.cases, false);
      list(state.route.cases, false);
      for (const BlockId entry : {state.entry, state.profile.entry, state.route.entry}) {
        Knowledge nothing;
        block(entry, nothing);
      }
    }
  }

  std::set<AssignmentPlace> kept;                   ///< of the doubtful ones
  std::map<CommandArgument, Interval> of_commands;  ///< where they are reached

 private:
  /// A case of `always` with a target may be passed over although its guard is true.
  void list(const std::vector<Case>& cases, bool always) {
    Knowledge before;
    for (size_t k = 0; k < cases.size(); ++k) {
      const Case& c = cases[k];
      Knowledge here = before;
      narrowing_.assume(here, c.guard, Asked::True);
      if (isDoubtful(c)) {
        assumePassed(here, std::span(cases).first(k), always);
      }
      block(c.action, here);
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        const Variable& parameter = m_[m_[c.target].parameters[i]];
        look({&c, i}, parameter, c.arguments[i], here);
      }
      if (isPassed(c, always)) {
        narrowing_.assume(before, c.guard, Asked::NotTrue);
      }
    }
  }

  /// Whether a later case of its list may fire only if its guard is not true.
  static bool isPassed(const Case& c, bool always) { return !always || !c.target.valid(); }

  /// Once more, with what the guard of a later case says: of `a && b` that was not true it may tell
  /// which.
  void assumePassed(Knowledge& here, std::span<const Case> before, bool always) {
    constexpr size_t kMost = 64;  // the nearest
    for (const Case& c : before.last(std::min(kMost, before.size()))) {
      if (isPassed(c, always)) {
        narrowing_.assume(here, c.guard, Asked::NotTrue);
      }
    }
  }

  [[nodiscard]] bool isDoubtful(const Case& c) const {
    return holdsDoubtful(&c, c.arguments.size()) || isDoubtful(c.action);
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] bool isDoubtful(BlockId id) const {
    if (!id.valid()) {
      return false;
    }
    const std::vector<Statement>& statements = m_[id].statements;
    return holdsDoubtful(&m_[id], statements.size()) ||
           std::ranges::any_of(statements, [&](const Statement& s) {
             return s.kind == StatementKind::If && (isDoubtful(s.then) || isDoubtful(s.otherwise));
           });
  }

  [[nodiscard]] bool holdsDoubtful(const void* owner, size_t places) const {
    const auto first = doubtful_.lower_bound({owner, 0});
    return first != doubtful_.end() && first->first == owner && first->second < places;
  }

  void look(const AssignmentPlace& place, const Variable& variable, ExprId value,
            const Knowledge& knowledge) {
    if (!doubtful_.contains(place)) {
      return;
    }
    const bool fits =
        knowledge.unreachable ||
        narrowing_.intervalOf(knowledge, value).within(variable.lowest, variable.highest);
    if (fits) {
      kept.insert(place);
    }
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void block(BlockId id, Knowledge& knowledge) {
    if (!id.valid()) {
      return;
    }
    const std::vector<Statement>& statements = m_[id].statements;
    for (size_t i = 0; i < statements.size(); ++i) {
      const Statement& s = statements[i];
      if (s.kind == StatementKind::If) {
        branch(s, knowledge);
      } else if (s.kind == StatementKind::Set && m_[s.variable].type.kind != TypeKind::Bool) {
        look({&m_[id], i}, m_[s.variable], s.value, knowledge);
        const Interval given = narrowing_.intervalOf(knowledge, s.value);
        narrowing_.set(knowledge, s.variable, given, !narrowing_.isAlwaysKnown(s.value));
      } else if (s.kind == StatementKind::Set) {
        narrowing_.set(knowledge, s.variable, {}, false);
      } else if (s.kind == StatementKind::Command && !knowledge.unreachable) {
        command(s, knowledge);
      }
    }
  }

  void command(const Statement& s, const Knowledge& knowledge) {
    for (size_t i = 0; i < s.values.size(); ++i) {
      of_commands.emplace(CommandArgument{&s, i}, narrowing_.intervalOf(knowledge, s.values[i]));
    }
  }

  /// An unknown condition takes neither branch.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void branch(const Statement& s, Knowledge& knowledge) {
    Knowledge yes = knowledge;
    Knowledge no = knowledge;
    narrowing_.assume(yes, s.value, Asked::True);
    narrowing_.assume(no, s.value, Asked::False);
    block(s.then, yes);
    block(s.otherwise, no);
    knowledge = common(knowledge, common(yes, no));
  }

  const Mission& m_;
  const std::set<AssignmentPlace>& doubtful_;
  Narrowing narrowing_;
};

}  // namespace

std::set<AssignmentPlace> keptByGuards(const Mission& mission,
                                       const std::vector<Interval>& intervals,
                                       const std::set<AssignmentPlace>& doubtful) {
  GuardedWalk walk(mission, intervals, doubtful);
  walk.run();
  return std::move(walk.kept);
}

std::map<CommandArgument, Interval> commandRanges(const Mission& mission,
                                                  const std::vector<Interval>& intervals) {
  const std::set<AssignmentPlace> none;
  GuardedWalk walk(mission, intervals, none);
  walk.run();
  return std::move(walk.of_commands);
}

}  // namespace glider::ir
