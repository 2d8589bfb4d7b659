// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/walk.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/energy/energy_bound.h"
#include "ir/prove/requirements/strategy.h"
#include "support/grouped.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace glider::ir::prove {
namespace {

/// A condition on `energyused`, and on nothing else that changes.
struct EnergyCondition {
  SensorId charge;
  VariableId first;  ///< the charge when the mission began
};

bool readsItself(const Mission& mission, VariableId variable, SensorId sensor) {
  const ExprId initial = mission[variable].initial;
  return initial.valid() && mission[initial].op == Op::Sensor && mission[initial].sensor == sensor;
}

/// Whether a difference is the charge since the mission began.
std::optional<EnergyCondition> usedBy(const Mission& mission, const Expr& e) {
  if (e.op != Op::Subtract) {
    return std::nullopt;
  }
  const Expr &charge = mission[e.operands[0]], &first = mission[e.operands[1]];
  if (charge.op != Op::Sensor || first.op != Op::Variable ||
      !readsItself(mission, first.variable, charge.sensor)) {
    return std::nullopt;
  }
  return EnergyCondition{charge.sensor, first.variable};
}

/// None: it reads something else, or the charge itself.
std::optional<EnergyCondition> energyCondition(const Mission& mission, ExprId condition,
                                               const platforms::Platform& platform) {
  std::optional<EnergyCondition> found;
  size_t differences = 0, charges = 0, others = 0;
  forEachIn(mission, condition, [&](const Expr& e) {
    if (const auto used = usedBy(mission, e)) {
      found = used;
      ++differences;
    }
    charges += e.op == Op::Sensor;
    others += e.op == Op::Variable || e.op == Op::Temporal || e.op == Op::Call || e.op == Op::Age;
  });
  const platforms::PlatformSensor* charge = platform.find("charge");
  const bool plain = found && platform.power.bounds && charge != nullptr &&
                     mission[found->charge].vehicle_name == charge->name;
  // Each is one expression, however often it is read.
  return plain && differences == charges && differences == others ? found : std::nullopt;
}

/// `always energyused <= E`: by the bound of what the mission takes from the batteries.
class Energy final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return requirement.kind == RequirementKind::Always && requirement.geofences.empty();
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    const Proof& proof = context.proof;
    const auto condition = energyCondition(context.mission, attempt.requirement.condition,
                                           proof.proof_context.platform);
    if (!condition || !proof.options.board) {
      return std::nullopt;
    }
    RequirementVerdict open{attempt.number, Verdict::Open, std::nullopt};
    if (!context.mission.shares.empty()) {
      open.reason = "what its acoustic modem takes has no bound here";
      return open;
    }
    const double most_j = mostOf(context);
    if (isKept(*condition, attempt.requirement.condition, most_j, context)) {
      return RequirementVerdict{attempt.number, Verdict::Proved, std::nullopt,
                                "by the vehicle's power table, while the SBC is in control"};
    }
    open.reason = whyOpen(most_j, context);
    return open;
  }

  RepeatedProof provesAgain(const RequirementVerdict& was,
                            StrategyContext& context) const override {
    Attempt attempt{was.requirement, context.mission.requirements[was.requirement]};
    return againBy(judge(attempt, context));
  }

  [[nodiscard]] std::optional<Evidence> evidence(const Requirement&, bool,
                                                 StrategyContext&) const override {
    return Evidence{Method::Energy, {}};
  }

 private:
  /// What the mission takes at most, J; infinite: no bound is known.
  static double mostOf(const StrategyContext& context) {
    const Proof& proof = context.proof;
    const auto bound = energyBoundOf(context.mission, proof.proof_context.platform,
                                     proof.options.board, Parameters::Any);
    return bound && bound->joules ? *bound->joules : std::numeric_limits<double>::infinity();
  }

  /// The charge that the vehicle counts for it: at the lowest voltage of the batteries, C.
  static double chargeOf(double joules, const StrategyContext& context) {
    return joules / context.proof.proof_context.platform.power.empty_V;
  }

  /// It does not matter what the count was when the mission began.
  static bool isKept(const EnergyCondition& of, ExprId condition, double most_j,
                     const StrategyContext& context) {
    const double charge = chargeOf(most_j, context);
    const ProofContext& proof_context = context.proof.proof_context;
    if (!(charge <= proof_context.sensors[of.charge.index].highest)) {
      return false;
    }
    Valuation values = anyValues(context.mission);
    values[of.first.index].lowest = values[of.first.index].highest = 0;
    constexpr Interval kAlways{0, kGreatestNumber, false};
    const AbstractEvaluator used(proof_context, values, {kAlways, kAlways, kAlways},
                                 AssumedReading{of.charge, {0, charge, false}, true});
    return !used.truth(condition).is_false;
  }

  static std::string whyOpen(double most_j, const StrategyContext& context) {
    if (!std::isfinite(most_j)) {
      return "no bound is known on how long the mission lasts, or it has too many transitions, so "
             "none is known on its energy";
    }
    const double counted = chargeOf(most_j, context) * context.mission.pack->voltage_V;
    const auto& variables = context.mission.variables;
    const bool set = !variables.empty() && variables.front().kind == VariableKind::Parameter;
    return fmt::format(
        "by the vehicle's power table it may take {} Wh{}, which its count of the charge may show "
        "as {} Wh when the batteries are low; `check --report` says what takes it",
        support::atMost(most_j / platforms::kJoulesPerWattHour),
        set ? " for some values of its parameters" : "",
        support::atMost(counted / platforms::kJoulesPerWattHour));
  }
};

}  // namespace

const Strategy& strategy::energy() {
  static const Energy kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
