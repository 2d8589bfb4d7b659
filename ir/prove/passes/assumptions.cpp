// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/under_assumptions.h"
#include "ir/prove/encoding/any_moment.h"
#include "ir/prove/passes.h"
#include "ir/verify/value_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace glider::ir::prove {
namespace {

using support::DiagnosticId;

constexpr double kAny = std::numeric_limits<double>::max();

/// False, and reported, if no reading of the vehicle is in an assumed range.
bool rangesOverlap(const Proof& proof, const Mission& mission) {
  bool right = true;
  for (const Assumption& a : mission.assumptions) {
    if (a.kind != AssumptionKind::Range) {
      continue;
    }
    const Sensor& narrowed = mission[a.sensor];
    if (narrowed.lowest > narrowed.highest) {
      const Sensor& vehicle = proof.proof_context.mission[a.sensor];
      proof.diagnostics.report(
          DiagnosticId::assumptionsContradict, a.range,
          fmt::format("no known reading of `{}`, which lies in {} to {}, is in all the ranges that "
                      "are assumed",
                      vehicle.name, withUnit(vehicle.lowest * vehicle.to_si, vehicle.type),
                      withUnit(vehicle.highest * vehicle.to_si, vehicle.type)));
      right = false;
    }
  }
  return right;
}

/// The condition that some assumption about a single moment is not true.
ExprId notAllTrue(Mission& mission, const std::vector<const Assumption*>& all) {
  const Type truth{TypeKind::Bool, {}};
  const auto push = [&](Op op, ExprId a, ExprId b) {
    Expr expr;
    expr.op = op;
    expr.type = truth;
    expr.operands = {a, b};
    mission.exprs.push_back(expr);
    return ExprId{static_cast<uint32_t>(mission.exprs.size() - 1)};
  };
  ExprId together = all.front()->watch.condition;
  for (const Assumption* a : all) {
    together = push(Op::And, together, a->watch.condition);
  }
  return push(Op::Not, together, {});
}

}  // namespace

/// Those with a monitor are satisfied by readings that never change.
void passes::assumptions(Proof& proof) {
  const Mission& written = proof.proof_context.mission;
  if (written.assumptions.empty()) {
    return;
  }
  Mission mission = underAssumptions(written);
  std::vector<const Assumption*> momentary;
  for (const Assumption& a : written.assumptions) {
    if (a.watch.condition.valid() && !a.watch.monitor.step.valid()) {
      momentary.push_back(&a);
    }
  }
  if (!rangesOverlap(proof, mission) || momentary.empty()) {
    return;
  }
  const ExprId contradiction = notAllTrue(mission, momentary);
  const ProofContext proof_context(mission, proof.proof_context.platform);
  const std::vector<StateBounds> bounds(mission.states.size(), {0, kAny, kAny, kAny, kAny});
  if (AnyMoment(proof_context, bounds)
          .neverFalse(contradiction, proof.options.effort, proof.checks)) {
    auto error =
        proof.diagnostics.report(DiagnosticId::assumptionsContradict, momentary.back()->range,
                                 "no known readings satisfy them all");
    for (const Assumption* a : momentary) {
      if (a != momentary.back()) {
        error.note(a->range, "together with this");
      }
    }
  }
}

}  // namespace glider::ir::prove
