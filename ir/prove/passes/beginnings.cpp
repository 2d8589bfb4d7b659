// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `beginnings`: profiles and routes that may command nothing when they begin (GL3107).
// Until the next command the vehicle then does what the state before had commanded, or nothing. In:
// what is never unknown (ProofContext::known, then the same for the values that variables are ever
// set to). No report is a proof that pitch, pump and heading are commanded after each tick (S2,
// S4), with one exception: the number of a place on a path is taken to be one of its rows if it may
// be. Not checked: code in C.

#include "ir/core/walk.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/context/never_unknown.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// The values that are never unknown when variables lie within the values that they are ever set
/// to. This takes some work, which few missions need.
struct Held {
  explicit Held(const Mission& mission)
      : ranges(heldIntervals(mission)), known(neverUnknown(mission, ranges)) {}

  std::vector<Interval> ranges;
  GreatestFixpoint known;
};

/// A command stays in force until the next one. So the commands that every profile and route gives
/// when it begins ensure that pitch, pump and heading are commanded after each tick.
class BeginningCheck {
 public:
  explicit BeginningCheck(Proof& proof) : proof_(proof), m_(proof.proof_context.mission) {}

  void run() {
    for (const State& state : m_.states) {
      check(state.profile, true, "this profile", "neither depth nor pitch");
      check(state.route, false, "this route", "no heading");
    }
  }

 private:
  void check(const Activity& activity, bool vertical, const char* who, const char* what) {
    const bool in_c = !m_[activity.behaviour].symbol.empty();
    if (in_c || commands(activity.entry, vertical)) {
      return;
    }
    if (told_.emplace(activity.range.file, activity.range.begin).second) {
      auto report = proof_.diagnostics.report(support::diagnostics::nothingCommanded,
                                              activity.range, who, what);
      const Unknown cause = unknownIn(activity.entry, vertical);
      if (!cause.name.empty()) {
        report.hint(fmt::format(
            "`{}` may be unknown, and then a command with it has no effect: {}{}", cause.name,
            cause.variable ? "give it a value from the start"
                           : "keep its last known value in a variable that has one from the "
                             "start, and use that",
            vertical ? "" : ", or command `drift()` first"));
      }
    }
  }

  /// A sensor, or a variable.
  struct Unknown {
    std::string name;
    bool variable = false;
  };

  /// Because of what a command that the block always gives may have no effect; without a name:
  /// there is no such command.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  Unknown unknownIn(BlockId block, bool vertical) {
    Unknown cause;
    if (!block.valid()) {
      return cause;
    }
    for (const Statement& statement : m_[block].statements) {
      if (statement.kind == StatementKind::If) {
        for (const BlockId branch : {statement.then, statement.otherwise}) {
          cause = cause.name.empty() ? unknownIn(branch, vertical) : cause;
        }
      }
      if (statement.kind == StatementKind::Command && isVertical(statement.command) == vertical) {
        forEachValue(statement, [&](ExprId value, const Expr& e) {
          if (e.op == Op::Sensor && !isKnown(value)) {
            cause = {m_[e.sensor].name, false};
          } else if (e.op == Op::Variable && !isKnown(value)) {
            cause = {m_[e.variable].name.substr(0, m_[e.variable].name.find('.')), true};
          }
        });
      }
    }
    return cause;
  }

  template <typename F>
  void forEachValue(const Statement& command, const F& f) const {
    for (const ExprId value : command.values) {
      forEachIn(m_, value, [&](const Expr& e) { f(value, e); });
    }
  }

  /// Whether every path through the block gives a command.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] bool commands(BlockId block, bool vertical) {
    if (!block.valid()) {
      return false;
    }
    return std::ranges::any_of(m_[block].statements, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Command) {
        return isVertical(statement.command) == vertical && takesEffect(statement);
      }
      // An unknown condition takes neither branch.
      return statement.kind == StatementKind::If && isKnown(statement.value) &&
             commandsIf(statement.value, true, statement.then, vertical) &&
             commandsIf(statement.value, false, statement.otherwise, vertical);
    });
  }

  /// The same for a branch, in which its condition is true, or false.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  bool commandsIf(ExprId condition, bool value, BlockId block, bool vertical) {
    const size_t before = shown_.size();
    addShown(condition, value);
    const bool found = commands(block, vertical);
    shown_.resize(before);
    return found;
  }

  /// Adds what is known if the condition has this value.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void addShown(ExprId condition, bool value) {
    const Expr& e = m_[condition];
    if (e.op == Op::Not) {
      addShown(e.operands[0], !value);
    } else if (e.op == Op::Known && value) {
      shown_.push_back(e.operands[0]);
    } else if (e.op == (value ? Op::And : Op::Or)) {
      addShown(e.operands[0], value);
      addShown(e.operands[1], value);
    }
  }

  /// A command with an unknown argument changes nothing. A place of a path counts as known if its
  /// number is sometimes one of the path's: cases may ensure that it always is.
  bool takesEffect(const Statement& command) {
    return std::ranges::all_of(command.values, [&](ExprId id) {
      const Expr& e = m_[id];
      return e.op == Op::Element ? isKnown(e.operands[0]) && mayBeRow(e) : isKnown(id);
    });
  }

  [[nodiscard]] bool mayBeRow(const Expr& element) const {
    const Interval& rows = proof_.proof_context.intervals[element.operands[0].index];
    const auto count = static_cast<double>(m_[element.table].values.size());
    return !rows.empty && rows.highest >= 0 && rows.lowest < count;
  }

  /// For any readings of the sensors.
  bool isKnown(ExprId id) {
    return proof_.proof_context.known.expressions[id.index] || held().known.expressions[id.index] ||
           (!shown_.empty() && knownWhere(m_, held().ranges, held().known, shown_)[id.index]);
  }

  const Held& held() {
    if (!held_) {
      held_.emplace(m_);
    }
    return *held_;
  }

  Proof& proof_;
  const Mission& m_;
  std::optional<Held> held_;
  std::vector<ExprId> shown_;  ///< known in the current branch
  std::set<std::pair<uint32_t, uint32_t>> told_;
};

}  // namespace

void passes::beginnings(Proof& proof) {
  BeginningCheck(proof).run();
}

}  // namespace glider::ir::prove
