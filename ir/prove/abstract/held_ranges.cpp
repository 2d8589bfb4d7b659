// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/held_ranges.h"

#include "ir/verify/intervals.h"

#include <algorithm>
#include <optional>

namespace glider::ir::prove {
namespace {

/// A variable that still grows after this many rounds gets its whole range.
constexpr int kRounds = 8;

/// The least fixpoint of the ranges, computed upwards from empty ones.
class HeldRanges {
 public:
  explicit HeldRanges(const Mission& mission) : m_(mission) {
    for (const Variable& v : m_.variables) {
      held_.push_back(v.kind == VariableKind::Parameter ? rangeOf(v) : Interval{0, 0, true});
    }
  }

  /// The range of every variable.
  std::vector<Interval> variables() {
    run();
    return std::move(held_);
  }

  /// The range of every expression.
  std::vector<Interval> run() {
    for (int round = 0;; ++round) {
      all_ = intervalsOf(m_, [&](const Expr& e) {
        return e.op == Op::Variable ? std::optional(held_[e.variable.index]) : std::nullopt;
      });
      grown_ = false;
      widen_ = round >= kRounds;
      gather();
      if (!grown_) {
        return std::move(all_);
      }
    }
  }

 private:
  static Interval rangeOf(const Variable& v) {
    return {std::max(v.lowest, -kGreatestNumber), std::min(v.highest, kGreatestNumber), false};
  }

  void gather() {
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      if (m_.variables[i].initial.valid()) {
        give({i}, m_.variables[i].initial);
      }
    }
    for (const Block& block : m_.blocks) {
      for (const Statement& s : block.statements) {
        if (s.kind == StatementKind::Set) {
          give(s.variable, s.value);
        }
      }
    }
    arguments(m_.always);
    for (const State& state : m_.states) {
      arguments(state.cases);
    }
  }

  void arguments(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        give(m_[c.target].parameters[i], c.arguments[i]);
      }
    }
  }

  /// No value leaves the variable's range: `ir/verify` has proved that.
  void give(VariableId id, ExprId value) {
    const Interval range = rangeOf(m_[id]);
    const Interval& x = all_[value.index];
    Interval& held = held_[id.index];
    const double lowest = std::max(x.lowest, range.lowest);
    const double highest = std::min(x.highest, range.highest);
    if (x.empty || lowest > highest) {
      return;
    }
    const Interval more = held.empty ? Interval{lowest, highest, false}
                                     : Interval{std::min(held.lowest, lowest),
                                                std::max(held.highest, highest), false};
    if (!held.empty && more.lowest == held.lowest && more.highest == held.highest) {
      return;
    }
    held = widen_ ? range : more;
    grown_ = true;
  }

  const Mission& m_;
  std::vector<Interval> held_;  ///< of every variable
  std::vector<Interval> all_;
  bool grown_ = false;
  bool widen_ = false;
};

}  // namespace

std::vector<Interval> heldVariables(const Mission& mission) {
  return HeldRanges(mission).variables();
}

std::vector<Interval> heldIntervals(const Mission& mission) {
  return HeldRanges(mission).run();
}

}  // namespace glider::ir::prove
