// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `stuckProfiles`: profiles meant to climb and dive that come to command one direction for
// good (GL3112). In: the profiles of the mission, not of the library; out: a warning at the case
// that leads there. Every combination of a profile's own truth values and its latest command is
// visited, comparisons having either result. A hint in one respect: whether some flight reaches the
// combination is not known. More than kMostTruths truth values: not checked.

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// What a profile remembers: its own truth values, and its latest command about depth.
struct Mode {
  std::vector<Truth> truths;  ///< of ProfileModes::own
  std::optional<Command> command;
  auto operator<=>(const Mode&) const = default;
};

/// The modes that a profile can be in, and how its cases lead from one to another. Sensors are
/// assumed to be known: what a profile does without them does not count as leaving a trap. A
/// comparison may have either result.
class ProfileModes {
 public:
  /// `resumes`: its state may be returned to, so that its entry runs again, in the current mode.
  ProfileModes(const Mission& mission, const Activity& profile, bool resumes)
      : m_(mission), profile_(profile), resumes_(resumes) {
    const auto gather = [&](const Statement& statement) {
      const bool sets = statement.kind == StatementKind::Set &&
                        m_[statement.variable].type.kind == TypeKind::Bool &&
                        m_[statement.variable].kind == VariableKind::Profile;
      if (sets && std::ranges::find(own_, statement.variable) == own_.end()) {
        own_.push_back(statement.variable);
      }
    };
    forEachStatement(m_, profile.entry, gather);
    for (const Case& c : profile.cases) {
      forEachStatement(m_, c.action, gather);
    }
  }

  /// False if there are too many.
  bool explore() {
    if (own_.size() > kMostTruths) {
      return false;
    }
    Mode start{{}, std::nullopt};
    for (const VariableId id : own_) {
      start.truths.push_back(judge(m_[id].initial, start));
    }
    for (const Mode& mode : run(profile_.entry, {start})) {
      arrive(mode, profile_.range);
    }
    while (!pending_.empty()) {
      const Mode mode = pending_.back();
      pending_.pop_back();
      follow(mode);
    }
    return true;
  }

  struct Trap {
    Command command;
    support::SourceRange range;  ///< of the case that leads into it
  };

  /// A mode from which only its own command is given, up or down, and the profile is never done.
  [[nodiscard]] std::optional<Trap> trap() const {
    for (const auto& [mode, range] : arrivals_) {
      const bool sloped = mode.command == Command::Descend || mode.command == Command::Ascend;
      if (sloped && !leadsToAnother(mode)) {
        return Trap{*mode.command, range};
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr size_t kMostTruths = 5;

  void arrive(const Mode& mode, const support::SourceRange& by) {
    if (arrivals_.emplace(mode, by).second) {
      pending_.push_back(mode);
    }
  }

  void follow(const Mode& mode) {
    if (resumes_) {
      for (const Mode& after : run(profile_.entry, {mode})) {
        next_[mode].insert(after);
        arrive(after, profile_.range);
      }
    }
    for (const Case& c : profile_.cases) {
      const Truth guard = judge(c.guard, mode);
      if (guard == Truth::False) {
        continue;
      }
      if (c.transition == Transition::Done) {
        ends_.insert(mode);
      }
      for (const Mode& after : run(c.action, {mode})) {
        next_[mode].insert(after);
        arrive(after, m_[c.guard].range);
      }
      if (guard == Truth::True) {
        return;  // it hides the rest
      }
    }
  }

  [[nodiscard]] bool leadsToAnother(const Mode& from) const {
    std::vector<Mode> pending{from};
    std::set<Mode> seen{from};
    while (!pending.empty()) {
      const Mode mode = pending.back();
      pending.pop_back();
      if (mode.command != from.command || ends_.contains(mode)) {
        return true;
      }
      const auto next = next_.find(mode);
      if (next == next_.end()) {
        continue;
      }
      for (const Mode& after : next->second) {
        if (seen.insert(after).second) {
          pending.push_back(after);
        }
      }
    }
    return false;
  }

  /// All modes in which a block may leave the profile if it starts in one of these.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  std::set<Mode> run(BlockId block, std::set<Mode> modes) const {
    if (!block.valid()) {
      return modes;
    }
    for (const Statement& statement : m_[block].statements) {
      std::set<Mode> after;
      for (const Mode& mode : modes) {
        after.merge(run(statement, mode));
      }
      modes = std::move(after);
    }
    return modes;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] std::set<Mode> run(const Statement& statement, Mode mode) const {
    if (statement.kind == StatementKind::If) {
      const Truth condition = judge(statement.value, mode);
      std::set<Mode> after;
      if (condition != Truth::False) {
        after.merge(run(statement.then, {mode}));
      }
      if (condition != Truth::True) {
        after.merge(run(statement.otherwise, {mode}));
      }
      return after;
    }
    const auto own = std::ranges::find(own_, statement.variable);
    if (statement.kind == StatementKind::Set && own != own_.end()) {
      return with(mode, static_cast<size_t>(own - own_.begin()), judge(statement.value, mode));
    }
    if (statement.kind == StatementKind::Command && isVertical(statement.command)) {
      mode.command = statement.command;
    }
    return {mode};
  }

  /// Unknown represents either value.
  static std::set<Mode> with(Mode mode, size_t number, Truth value) {
    if (value != Truth::Unknown) {
      mode.truths[number] = value;
      return {mode};
    }
    std::set<Mode> both;
    for (const Truth each : {Truth::False, Truth::True}) {
      mode.truths[number] = each;
      both.insert(mode);
    }
    return both;
  }

  /// Unknown: either value is possible.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] Truth judge(ExprId id, const Mode& mode) const {
    const Expr& e = m_[id];
    const auto operand = [&](size_t i) { return judge(e.operands.at(i), mode); };
    if (groupOf(e.op) == OpGroup::Truth || e.op == Op::Known) {
      return truth(e.op != Op::False);
    }
    if (groupOf(e.op) == OpGroup::Logic) {
      return logical(opIn<LogicOp>(e.op), operand);
    }
    const auto own = e.op == Op::Variable ? std::ranges::find(own_, e.variable) : own_.end();
    const auto number = static_cast<size_t>(own - own_.begin());
    return number < mode.truths.size() ? mode.truths[number] : Truth::Unknown;
  }

  const Mission& m_;
  const Activity& profile_;
  bool resumes_;
  std::vector<VariableId> own_;
  std::map<Mode, support::SourceRange> arrivals_;  ///< the case by which each was first reached
  std::map<Mode, std::set<Mode>> next_;
  std::set<Mode> ends_;  ///< in which it may be done
  std::vector<Mode> pending_;
};

/// A profile that only goes one way is intended to do so.
bool goesBothWays(const Mission& mission, const Activity& profile) {
  bool down = false;
  bool up = false;
  for (const Statement* statement : commandsOf(mission, profile)) {
    down = down || statement->command == Command::Descend || statement->command == Command::Hover;
    up = up || statement->command == Command::Ascend || statement->command == Command::Surface;
  }
  return down && up;
}

/// Whether some of the cases may call a state, which may return.
bool mayCall(const Proof& proof, StateId state, const std::vector<Case>& cases) {
  for (uint32_t i = 0; i < cases.size(); ++i) {
    if (cases[i].transition == Transition::Call && !proof.dead.contains({state, i})) {
      return true;
    }
  }
  return false;
}

}  // namespace

void passes::stuckProfiles(Proof& proof) {
  const Mission& m = proof.proof_context.mission;
  std::set<std::pair<uint32_t, uint32_t>> told;
  const bool always_calls = mayCall(proof, StateId(), m.always);
  for (uint32_t i = 0; i < m.states.size(); ++i) {
    const State& state = m.states[i];
    const bool own = !state.profile.cases.empty() &&
                     state.profile.cases.front().range.file != proof.options.library;
    ProfileModes modes(m, state.profile, always_calls || mayCall(proof, {i}, state.cases));
    if (!own || !goesBothWays(m, state.profile) || !modes.explore()) {
      continue;
    }
    const auto trap = modes.trap();
    if (trap && told.emplace(trap->range.file, trap->range.begin).second) {
      const bool dives = trap->command == Command::Descend;
      proof.diagnostics.report(support::diagnostics::profileStuck, trap->range,
                               dives ? "dive" : "climb", dives ? "climb" : "dive");
    }
  }
}

}  // namespace glider::ir::prove
