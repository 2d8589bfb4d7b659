// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/known_roughly.h"

#include "ir/core/ops.h"
#include "ir/prove/context/vehicle_clock.h"

#include <fmt/ranges.h>

#include <optional>
#include <set>
#include <vector>

namespace glider::ir::prove {
namespace {

/// In the order in which they are named.
enum class Approximation : uint8_t {
  Product,
  Quotient,
  Angle,
  Function,
  Place,
  Watched,
  Window,
  Code,
  Clock
};

const char* nameOf(Approximation rough) {
  switch (rough) {
    case Approximation::Product:
      return "products of values that are measured or change";
    case Approximation::Quotient:
      return "quotients of values that are measured or change";
    case Approximation::Angle:
      return "square roots and angles";
    case Approximation::Function:
      return "functions of numbers";
    case Approximation::Place:
      return "positions, their distances and bearings";
    case Approximation::Watched:
      return "what `became` and `held` observe between two ticks";
    case Approximation::Window:
      return "windows";
    case Approximation::Code:
      return "C functions";
    case Approximation::Clock:
      return "the vehicle's clock, which a search does not tie to `missiontime`";
  }
  return "";
}

std::optional<Approximation> roughnessOf(UnaryOp op) {
  switch (op) {
    case UnaryOp::Negate:
    case UnaryOp::Abs:
      return std::nullopt;
    case UnaryOp::Sqrt:
      break;
  }
  return Approximation::Angle;
}

std::optional<Approximation> roughnessOf(BinaryOp op, const Expr& a, const Expr& b) {
  const auto unless = [](bool exact, Approximation rough) {
    return exact ? std::nullopt : std::optional(rough);
  };
  switch (op) {
    case BinaryOp::Multiply:
      return unless(a.op == Op::Constant || b.op == Op::Constant, Approximation::Product);
    case BinaryOp::Divide:
      return unless(b.op == Op::Constant, Approximation::Quotient);
    case BinaryOp::Add:
    case BinaryOp::Subtract:
    case BinaryOp::Min:
    case BinaryOp::Max:
      break;
  }
  return std::nullopt;
}

Approximation roughnessOf(const OpInfo& function) {
  if (function.takes == Takes::Places || function.takes == Takes::Course) {
    return Approximation::Place;
  }
  const bool angle = function.takes == Takes::Angle || function.gives == Gives::Angle;
  return angle ? Approximation::Angle : Approximation::Function;
}

/// The approximation that SymbolicState makes.
std::optional<Approximation> roughnessOf(const ProofContext& proof_context, const Expr& e) {
  const Mission& m = proof_context.mission;
  switch (groupOf(e.op)) {
    case OpGroup::Unary:
      return roughnessOf(opIn<UnaryOp>(e.op));
    case OpGroup::Binary:
      return roughnessOf(opIn<BinaryOp>(e.op), m[e.operands[0]], m[e.operands[1]]);
    case OpGroup::Function:
      return roughnessOf(opInfo(e.op));
    case OpGroup::Element:
      return Approximation::Place;
    case OpGroup::Temporal:
      return isWindow(m[e.temporal].kind) ? Approximation::Window : Approximation::Watched;
    case OpGroup::Call:
      return Approximation::Code;
    case OpGroup::Sensor:
      return isVehicleClock(proof_context.platformSensor(e.sensor))
                 ? std::optional(Approximation::Clock)
                 : std::nullopt;
    case OpGroup::Constant:
    case OpGroup::Truth:
    case OpGroup::Clock:
    case OpGroup::Variable:
    case OpGroup::Age:
    case OpGroup::Clamp:
    case OpGroup::Select:
    case OpGroup::Comparison:
    case OpGroup::Known:
    case OpGroup::Logic:
      break;
  }
  return std::nullopt;
}

/// Whether a profile or route in C is in the cone of influence: it may command anything.
bool hasCode(const Mission& m, const ConeOfInfluence& relevance) {
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

std::string knownRoughly(const ProofContext& proof_context, const ConeOfInfluence& relevance) {
  const Mission& mission = proof_context.mission;
  std::set<Approximation> found;
  for (size_t i = 0; i < mission.exprs.size(); ++i) {
    if (relevance.expressions[i]) {
      if (const auto rough = roughnessOf(proof_context, mission.exprs[i])) {
        found.insert(*rough);
      }
    }
  }
  if (hasCode(mission, relevance)) {
    found.insert(Approximation::Code);
  }
  std::vector<std::string> names;
  for (const Approximation rough : found) {
    names.emplace_back(nameOf(rough));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace glider::ir::prove
