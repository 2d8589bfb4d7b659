// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/known_roughly.h"

#include "ir/core/ops.h"

#include <fmt/ranges.h>

#include <optional>
#include <set>
#include <vector>

namespace glider::ir::prove {
namespace {

/// In the order in which they are named.
enum class Rough : uint8_t { Product, Quotient, Function, Place, Watched, Window, Code };

const char* nameOf(Rough rough) {
  switch (rough) {
    case Rough::Product:
      return "products of values that are measured or change";
    case Rough::Quotient:
      return "quotients of values that are measured or change";
    case Rough::Function:
      return "square roots and angles";
    case Rough::Place:
      return "positions, their distances and bearings";
    case Rough::Watched:
      return "what `became` and `held` observe between two ticks";
    case Rough::Window:
      return "windows";
    case Rough::Code:
      return "C functions";
  }
  return "";
}

bool isConstant(const Mission& m, ExprId id) {
  return m[id].op == Op::Constant;
}

/// As Moment takes it.
std::optional<Rough> roughnessOf(const Mission& m, const Expr& e) {
  switch (e.op) {
    case Op::Multiply:
      return isConstant(m, e.operands[0]) || isConstant(m, e.operands[1])
                 ? std::nullopt
                 : std::optional(Rough::Product);
    case Op::Divide:
      return isConstant(m, e.operands[1]) ? std::nullopt : std::optional(Rough::Quotient);
    case Op::Sqrt:
    case Op::Sin:
    case Op::Cos:
    case Op::Tan:
    case Op::Atan2:
      return Rough::Function;
    case Op::Distance:
    case Op::Bearing:
    case Op::Element:
      return Rough::Place;
    case Op::Temporal:
      return isWindow(m[e.temporal].kind) ? Rough::Window : Rough::Watched;
    case Op::Call:
      return Rough::Code;
    default:
      return std::nullopt;
  }
}

/// Whether a profile or route in C matters: it may order anything.
bool hasCode(const Mission& m, const Relevance& relevance) {
  for (size_t i = 0; i < m.states.size(); ++i) {
    const State& state = m.states[i];
    if ((relevance.profiles[i] && !m[state.profile.behaviour].symbol.empty()) ||
        (relevance.routes[i] && !m[state.route.behaviour].symbol.empty())) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::string knownRoughly(const Mission& mission, const Relevance& relevance) {
  std::set<Rough> found;
  for (size_t i = 0; i < mission.exprs.size(); ++i) {
    if (relevance.expressions[i]) {
      if (const auto rough = roughnessOf(mission, mission.exprs[i])) {
        found.insert(*rough);
      }
    }
  }
  if (hasCode(mission, relevance)) {
    found.insert(Rough::Code);
  }
  std::vector<std::string> names;
  for (const Rough rough : found) {
    names.emplace_back(nameOf(rough));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace glider::ir::prove
