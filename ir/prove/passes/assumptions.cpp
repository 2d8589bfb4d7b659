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

/// A condition, and where it is written.
struct Said {
  ExprId condition;
  support::SourceRange range;
};

/// The condition that not all are true.
ExprId notAllTrue(Mission& mission, const std::vector<Said>& all) {
  const auto push = [&](Op op, ExprId a, ExprId b) {
    Expr expr;
    expr.op = op;
    expr.type = {TypeKind::Bool, {}};
    expr.operands = {a, b};
    mission.exprs.push_back(expr);
    return ExprId{static_cast<uint32_t>(mission.exprs.size() - 1)};
  };
  ExprId together = all.front().condition;
  for (const Said& one : all) {
    together = push(Op::And, together, one.condition);
  }
  return push(Op::Not, together, {});
}

/// Reports if no known readings make all conditions true. `mission` may have fewer readings than
/// the one that is checked.
void compare(Proof& proof, Mission mission, const std::vector<Said>& all, DiagnosticId id,
             const char* words) {
  if (all.size() < 2) {
    return;
  }
  const ExprId contradiction = notAllTrue(mission, all);
  const ProofContext proof_context(mission, proof.proof_context.platform);
  const std::vector<StateBounds> bounds(mission.states.size(), {0, kAny, kAny, kAny, kAny});
  if (AnyMoment(proof_context, bounds)
          .neverFalse(contradiction, proof.options.effort, proof.checks)) {
    auto error = proof.diagnostics.report(id, all.back().range, words);
    for (size_t i = 0; i + 1 < all.size(); ++i) {
      error.note(all[i].range, "together with this");
    }
  }
}

/// It is about a single moment: those with a monitor are satisfied by readings that never change.
bool isMomentary(const Requirement& requirement) {
  return requirement.condition.valid() && !requirement.monitor.step.valid();
}

}  // namespace

void passes::assumptions(Proof& proof) {
  const Mission& written = proof.proof_context.mission;
  const Mission mission = underAssumptions(written);
  std::vector<Said> assumed;
  for (const Assumption& a : written.assumptions) {
    if (isMomentary(a.watch)) {
      assumed.push_back({a.watch.condition, a.range});
    }
  }
  if (rangesOverlap(proof, mission)) {
    compare(proof, mission, assumed, DiagnosticId::assumptionsContradict,
            "no known readings satisfy them all");
  }
}

void passes::contradictions(Proof& proof) {
  std::vector<Said> required;
  for (const Requirement& r : proof.proof_context.mission.requirements) {
    if (isMomentary(r)) {
      required.push_back({r.condition, r.range});
    }
  }
  compare(proof, proof.proof_context.mission, required, DiagnosticId::requirementsContradict,
          "no known readings satisfy them all");
}

}  // namespace glider::ir::prove
