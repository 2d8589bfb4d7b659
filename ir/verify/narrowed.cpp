// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/narrowed.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/verify/whole_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace glider::ir {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr unsigned kDeepestNarrowed = 100;  ///< conditions that nest deeper are ignored

Interval intersection(const Interval& a, const Interval& b) {
  const double lowest = std::max(a.lowest, b.lowest);
  const double highest = std::min(a.highest, b.highest);
  const bool empty = a.empty || b.empty || lowest > highest;
  return empty ? Interval{0, 0, true} : Interval{lowest, highest, false};
}

/// Everything that gives two expressions the same value at every moment; for a Call its use.
auto keyOf(const Expr& e, const std::array<ExprId, kMostOperands>& operands) {
  return std::tuple(e.op, e.type.kind, operands, std::bit_cast<uint64_t>(e.number), e.sensor,
                    e.variable, e.temporal, e.table, e.use);
}

}  // namespace

Knowledge common(const Knowledge& a, const Knowledge& b) {
  if (a.unreachable || b.unreachable) {
    return a.unreachable ? b : a;
  }
  Knowledge both;
  for (const auto& [expression, interval] : a.within) {
    if (const auto other = b.within.find(expression); other != b.within.end()) {
      both.within.emplace(expression, hull(interval, other->second));
    }
  }
  std::ranges::set_intersection(a.known, b.known, std::inserter(both.known, both.known.end()));
  return both;
}

Narrowing::Narrowing(const Mission& mission, const std::vector<Interval>& intervals)
    : m_(mission),
      plain_(intervals),
      whole_(wholeExpressions(mission, intervals)),
      read_as_(mission.variables.size()),
      work_(mission) {
  std::map<decltype(keyOf(mission.exprs.front(), {})), uint32_t> firsts;
  for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
    const Expr& e = m_.exprs[i];
    std::array<ExprId, kMostOperands> operands;
    for (uint32_t k = 0; k < operandCount(e); ++k) {
      operands.at(k) = ExprId{first_[e.operands.at(k).index]};
    }
    first_.push_back(firsts.emplace(keyOf(e, operands), i).first->second);
    if (e.op == Op::Variable) {
      read_as_[e.variable.index] = first_.back();
    }
  }
}

Interval Narrowing::intervalOf(const Knowledge& knowledge, ExprId id) {
  return work_.of(id, [&](uint32_t index, const Interval& made) {
    // A window contains values from before the conditions were evaluated.
    const Interval& now = m_.exprs[index].op == Op::Temporal ? plain_[index] : made;
    const auto known = knowledge.within.find(first_[index]);
    return known == knowledge.within.end() ? now : intersection(now, known->second);
  });
}

bool Narrowing::isAlwaysKnown(ExprId id) const {
  const Expr& e = m_[id];
  return e.op == Op::Constant || groupOf(e.op) == OpGroup::Clock ||
         (e.op == Op::Variable && m_[e.variable].kind == VariableKind::Parameter);
}

bool Narrowing::isKnown(const Knowledge& knowledge, ExprId id) const {
  return isAlwaysKnown(id) || knowledge.known.contains(first_[id.index]);
}

void Narrowing::set(Knowledge& knowledge, VariableId variable, Interval given, bool kept) {
  const Variable& v = m_[variable];
  const Interval range{v.lowest, v.highest, false};
  std::optional<uint32_t> itself;
  Interval before = range;
  const auto reads = [&](uint32_t id) {
    return anyIn(m_, ExprId{id},
                 [&](const Expr& x) { return x.op == Op::Variable && x.variable == variable; });
  };
  std::erase_if(knowledge.within, [&](const auto& entry) {
    const Expr& e = m_.exprs[entry.first];
    if (e.op == Op::Variable && e.variable == variable) {
      itself = entry.first;
      before = entry.second;
    }
    return reads(entry.first);
  });
  std::erase_if(knowledge.known, reads);
  if (v.type.kind == TypeKind::Bool) {
    return;
  }
  itself = itself ? itself : read_as_[variable.index];
  if (!itself) {
    return;  // no expression reads it
  }
  const Interval after = intersection(range, given);
  knowledge.within.emplace(*itself, kept ? hull(before, after) : after);
}

// NOLINTNEXTLINE(misc-no-recursion): no deeper than kDeepestNarrowed
void Narrowing::assume(Knowledge& knowledge, ExprId condition, Asked asked, unsigned depth) {
  const Expr& e = m_[condition];
  if (knowledge.unreachable || depth > kDeepestNarrowed) {
    return;
  }
  const bool true_or_unknown = asked == Asked::True || asked == Asked::NotFalse;
  if (groupOf(e.op) == OpGroup::Truth) {
    knowledge.unreachable = (e.op == Op::True) != true_or_unknown;
  } else if (isComparison(e.op)) {
    compare(knowledge, e, asked);
  } else if (groupOf(e.op) == OpGroup::Logic) {
    switch (opIn<LogicOp>(e.op)) {
      case LogicOp::Not: {
        constexpr Asked kOpposite[] = {Asked::False, Asked::True, Asked::NotFalse, Asked::NotTrue};
        return assume(knowledge, e.operands[0], kOpposite[static_cast<size_t>(asked)], depth + 1);
      }
      case LogicOp::And:
      case LogicOp::Or:
        return (e.op == Op::And) == true_or_unknown ? assumeBoth(knowledge, e, asked, depth)
                                                    : assumeEither(knowledge, e, asked, depth);
    }
  }
}

// NOLINTNEXTLINE(misc-no-recursion): no deeper than kDeepestNarrowed
void Narrowing::assumeBoth(Knowledge& knowledge, const Expr& e, Asked asked, unsigned depth) {
  assume(knowledge, e.operands[0], asked, depth + 1);
  assume(knowledge, e.operands[1], asked, depth + 1);
}

// NOLINTNEXTLINE(misc-no-recursion): no deeper than kDeepestNarrowed
void Narrowing::assumeEither(Knowledge& knowledge, const Expr& e, Asked asked, unsigned depth) {
  Knowledge other = knowledge;
  assume(knowledge, e.operands[0], asked, depth + 1);
  assume(other, e.operands[1], asked, depth + 1);
  knowledge = common(knowledge, other);
}

/// A comparison that is not true is false or unknown. It restricts one side only if the other is
/// known: otherwise that side may be the reason.
void Narrowing::compare(Knowledge& knowledge, const Expr& e, Asked asked) {
  const bool definite = asked == Asked::True || asked == Asked::False ||
                        (isKnown(knowledge, e.operands[0]) && isKnown(knowledge, e.operands[1]));
  const bool holds = asked == Asked::True || asked == Asked::NotFalse;
  const Op op = holds ? e.op : negated(e.op);
  const Interval left = intervalOf(knowledge, e.operands[0]);
  const Interval right = intervalOf(knowledge, e.operands[1]);
  if (left.empty || right.empty) {
    knowledge.unreachable = definite;  // a side is never known
    return;
  }
  if (definite) {
    knowledge.known.insert({first_[e.operands[0].index], first_[e.operands[1].index]});
  }
  if (definite || isKnown(knowledge, e.operands[1])) {
    narrow(knowledge, e.operands[0], op, right, definite);
  }
  if (definite || isKnown(knowledge, e.operands[0])) {
    narrow(knowledge, e.operands[1], mirrored(op), left, definite);
  }
}

void Narrowing::narrow(Knowledge& knowledge, ExprId side, Op op, const Interval& other,
                       bool definite) {
  const Interval now = intervalOf(knowledge, side);
  const Interval left = intersection(now, allowed(side, op, now, other));
  knowledge.unreachable = knowledge.unreachable || (definite && left.empty);
  if (m_[side].op != Op::Constant) {
    knowledge.within.insert_or_assign(first_[side.index], left);
  }
}

/// The values that `side` may have if it compares this way with a value in `other`.
Interval Narrowing::allowed(ExprId side, Op op, const Interval& now, const Interval& other) const {
  const bool whole = whole_[side.index];
  const double below =
      whole ? std::ceil(other.highest) - 1 : std::nextafter(other.highest, -kEndless);
  const double above =
      whole ? std::floor(other.lowest) + 1 : std::nextafter(other.lowest, kEndless);
  switch (opIn<ComparisonOp>(op)) {
    case ComparisonOp::Less:
      return {-kEndless, below, false};
    case ComparisonOp::LessEqual:
      return {-kEndless, whole ? std::floor(other.highest) : other.highest, false};
    case ComparisonOp::Greater:
      return {above, kEndless, false};
    case ComparisonOp::GreaterEqual:
      return {whole ? std::ceil(other.lowest) : other.lowest, kEndless, false};
    case ComparisonOp::Equal:
      return other;
    case ComparisonOp::NotEqual:
      break;
  }
  // An end of the interval is excluded.
  const bool single = other.lowest == other.highest;
  return {single && now.lowest == other.lowest ? above : now.lowest,
          single && now.highest == other.highest ? below : now.highest, false};
}

}  // namespace glider::ir
