// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/dnf.h"

#include "ir/core/ops.h"

#include <algorithm>
#include <utility>

namespace glider::ir::opt {
namespace {

using Disjunction = std::vector<Conjunction>;

/// A guard with more alternatives is left as it is.
constexpr size_t kMostAlternatives = 8;
constexpr uint32_t kDeepestForm = 64;

/// Kleene's logic split into two-valued questions: "is this true?", "is this false?". `not` swaps
/// them, and each comparison of known numbers is true or false, so the two forms below are
/// sufficient.
enum class Wanted : uint8_t { True, False };

Wanted opposite(Wanted wanted) {
  return wanted == Wanted::True ? Wanted::False : Wanted::True;
}

bool earlier(const Cut& a, const Cut& b) {
  return a.at != b.at ? a.at < b.at : a.inclusive && !b.inclusive;
}

Conjunction single(const Watched& watched, const Bounds& bounds) {
  Conjunction result;
  result.bounds.emplace(watched, bounds);
  return result;
}

/// "True": no bounds.
Disjunction always() {
  return {Conjunction{}};
}

/// A condition that bounds cannot express.
Disjunction opaque() {
  Conjunction result;
  result.exact = false;
  return {result};
}

bool possible(const Bounds& bounds) {
  if (bounds.unknown) {
    return !bounds.above && !bounds.below;
  }
  return !bounds.above || !bounds.below || earlier(*bounds.above, *bounds.below);
}

/// Both together; empty if they contradict each other.
std::optional<Bounds> both(const Bounds& a, const Bounds& b) {
  if (a.unknown != b.unknown) {
    return std::nullopt;
  }
  Bounds result = a;
  if (b.above && (!result.above || earlier(*result.above, *b.above))) {
    result.above = b.above;
  }
  if (b.below && (!result.below || earlier(*b.below, *result.below))) {
    result.below = b.below;
  }
  return possible(result) ? std::optional(result) : std::nullopt;
}

std::optional<Conjunction> both(const Conjunction& a, const Conjunction& b) {
  Conjunction result = a;
  result.exact = a.exact && b.exact;
  for (const auto& [watched, bounds] : b.bounds) {
    const auto [place, fresh] = result.bounds.emplace(watched, bounds);
    if (!fresh) {
      const auto joined = both(place->second, bounds);
      if (!joined) {
        return std::nullopt;
      }
      place->second = *joined;
    }
  }
  return result;
}

class Former {
 public:
  explicit Former(const Mission& mission) : m_(mission) {}

  Disjunction form(ExprId id, Wanted wanted, uint32_t depth) {
    const Expr& e = m_[id];
    if (depth > kDeepestForm) {
      return opaque();
    }
    switch (groupOf(e.op)) {
      case OpGroup::Truth:
        return (e.op == Op::True) == (wanted == Wanted::True) ? always() : Disjunction{};
      case OpGroup::Logic:
        return logic(e, wanted, depth);
      case OpGroup::Known:
        return known(e, wanted);
      case OpGroup::Comparison:
        return comparison(e, wanted);
      case OpGroup::Variable:
      case OpGroup::Temporal:
      case OpGroup::Call:
      case OpGroup::Constant:
      case OpGroup::Sensor:
      case OpGroup::Clock:
      case OpGroup::Age:
      case OpGroup::Unary:
      case OpGroup::Binary:
      case OpGroup::Function:
      case OpGroup::Clamp:
      case OpGroup::Select:
      case OpGroup::Element:
        break;
    }
    return opaque();
  }

 private:
  Disjunction logic(const Expr& e, Wanted wanted, uint32_t depth) {
    switch (opIn<LogicOp>(e.op)) {
      case LogicOp::Not:
        return form(e.operands[0], opposite(wanted), depth + 1);
      case LogicOp::And:
      case LogicOp::Or:
        break;
    }
    const Disjunction a = form(e.operands[0], wanted, depth + 1);
    const Disjunction b = form(e.operands[1], wanted, depth + 1);
    return (e.op == Op::And) == (wanted == Wanted::True) ? all(a, b) : any(a, b);
  }

  static Disjunction any(Disjunction a, const Disjunction& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a.size() > kMostAlternatives ? opaque() : a;
  }

  static Disjunction all(const Disjunction& a, const Disjunction& b) {
    Disjunction result;
    for (const Conjunction& x : a) {
      for (const Conjunction& y : b) {
        if (auto joined = both(x, y)) {
          result.push_back(std::move(*joined));
        }
      }
    }
    return result.size() > kMostAlternatives ? opaque() : result;
  }

  std::optional<Watched> watched(ExprId id) const {
    const Expr& e = m_[id];
    const bool fits = e.op == Op::Sensor || groupOf(e.op) == OpGroup::Clock;
    return fits ? std::optional(Watched{e.op, e.sensor}) : std::nullopt;
  }

  Disjunction known(const Expr& e, Wanted wanted) const {
    const auto operand = watched(e.operands[0]);
    if (!operand) {
      return opaque();
    }
    return {single(*operand, {std::nullopt, std::nullopt, wanted == Wanted::False})};
  }

  Disjunction comparison(const Expr& e, Wanted wanted) const {
    const auto left = watched(e.operands[0]);
    const auto right = watched(e.operands[1]);
    const Expr& a = m_[e.operands[0]];
    const Expr& b = m_[e.operands[1]];
    const Op op = wanted == Wanted::True ? e.op : negated(e.op);
    if (left && b.op == Op::Constant) {
      return compared(*left, op, b.number);
    }
    if (right && a.op == Op::Constant) {
      return compared(*right, mirrored(op), a.number);
    }
    return opaque();
  }

  static Disjunction compared(const Watched& what, Op op, double constant) {
    const Cut from{constant + 0.0, true};  // -0 and 0 are the same place
    const Cut past{constant + 0.0, false};
    const Conjunction less = single(what, {std::nullopt, from, false});
    const Conjunction greater = single(what, {past, std::nullopt, false});
    switch (opIn<ComparisonOp>(op)) {
      case ComparisonOp::Less:
        return {less};
      case ComparisonOp::LessEqual:
        return {single(what, {std::nullopt, past, false})};
      case ComparisonOp::Greater:
        return {greater};
      case ComparisonOp::GreaterEqual:
        return {single(what, {from, std::nullopt, false})};
      case ComparisonOp::Equal:
        return {single(what, {from, past, false})};
      case ComparisonOp::NotEqual:
        break;
    }
    return {less, greater};
  }

  const Mission& m_;
};

}  // namespace

std::vector<Conjunction> disjunctionOf(const Mission& mission, ExprId guard) {
  return Former(mission).form(guard, Wanted::True, 0);
}

}  // namespace glider::ir::opt
