// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/safety_properties.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/encoding/cone_of_influence.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace glider::ir::prove {
namespace {

bool readsDepth(ExprId root, const ProofContext& proof_context) {
  return anyIn(proof_context.mission, root, [&](const Expr& e) {
    return e.op == Op::Sensor && e.sensor == proof_context.depth;
  });
}

/// The mission still flies although its time is over: a tick that ends it then is too late.
SafetyProperty exitWithin(double seconds, z3::context& context) {
  SafetyProperty watch;
  watch.bad_at_tick = [seconds, &context](const Configuration& left, SymbolicState&) {
    return std::optional(left.mission_time > realOf(context, seconds));
  };
  return watch;
}

/// Whether the outcome enters `state` by goto or call; a return does not count as entering.
bool enters(const Outcome& outcome, StateId state) {
  return outcome.fired && outcome.after && outcome.after->control.state == state &&
         !outcome.after->control.just_returned;
}

SafetyProperty reaching(StateId state, z3::context& context) {
  SafetyProperty watch;
  if (state.index == 0) {
    watch.bad_after = [&context](const Configuration& now) {
      return std::optional(now.control.state.index == 0 && now.control.stack.empty()
                               ? context.bool_val(true)
                               : context.bool_val(false));
    };
    return watch;
  }
  watch.bad_move = [state, &context](const Configuration&, const Outcome& outcome) {
    return enters(outcome, state) ? std::optional(context.bool_val(true)) : std::nullopt;
  };
  return watch;
}

/// The memory holds whether `after` has been entered.
SafetyProperty neverAfter(StateId state, StateId after, z3::context& context) {
  SafetyProperty watch;
  watch.memory = {{"after seen", context.bool_sort()}};
  watch.begin = [after, &context](Configuration& start) {
    start.memory = {context.bool_val(after.index == 0)};
  };
  watch.move = [after, &context](const Configuration& before, const Outcome& outcome,
                                 Configuration& next) {
    next.memory = {enters(outcome, after) ? context.bool_val(true) : before.memory.front()};
  };
  watch.bad_move = [state](const Configuration& before,
                           const Outcome& outcome) -> std::optional<z3::expr> {
    return enters(outcome, state) ? std::optional(before.memory.front()) : std::nullopt;
  };
  return watch;
}

/// The memory holds when the vehicle was last at the surface.
SafetyProperty surfacesEvery(double seconds, z3::context& context,
                             const ProofContext& proof_context) {
  SafetyProperty watch;
  watch.memory = {{"surfaced", context.real_sort()}};
  const double surface = proof_context.platform.world.surface_depth_m;
  watch.begin = [&context](Configuration& start) { start.memory = {context.real_val(0)}; };
  watch.elapse = [surface, &context](const Configuration& before, Configuration& after) {
    after.memory = {z3::ite(after.store.vehicle->depth <= realOf(context, surface),
                            after.mission_time, before.memory.front())};
  };
  watch.move = [](const Configuration& before, const Outcome&, Configuration& after) {
    after.memory = before.memory;
  };
  watch.bad_at_tick = [seconds, &context](const Configuration& left, SymbolicState&) {
    return std::optional(left.mission_time - left.memory.front() > realOf(context, seconds));
  };
  return watch;
}

/// A requirement is evaluated at a moment in which the depth reading is the true depth.
void showTrueDepth(const Configuration& now, SymbolicState& moment,
                   const ProofContext& proof_context) {
  if (proof_context.depth && now.store.vehicle) {
    (void)moment.age(*proof_context.depth);  // of the reading, which may be unknown
    moment.setReading(*proof_context.depth,
                      NumberTerm{now.store.vehicle->depth, moment.context().bool_val(true), 0});
    moment.forget();
  }
}

z3::expr isFalse(ExprId condition, const Configuration& now, SymbolicState moment,
                 const ProofContext& proof_context) {
  showTrueDepth(now, moment, proof_context);
  return moment.truth(condition).is_false;
}

bool observed(const Observation& observation, const Outcome* outcome, const Configuration& left) {
  switch (observation.kind) {
    case ObservationKind::Entered:
      return outcome == nullptr ? left.control.state == observation.state
                                : enters(*outcome, observation.state);
    case ObservationKind::Inside:
      return left.control.holds(observation.state);
    case ObservationKind::Ended:
      break;
  }
  return outcome != nullptr && !outcome->after;
}

/// What the monitor does, as in the interpreter (ir/README.md, Monitors).
void observe(const Monitor& monitor, const Outcome* outcome, Configuration& left,
             SymbolicState& moment, const ProofContext& proof_context,
             const ConeOfInfluence& relevance) {
  z3::context& context = moment.context();
  for (auto& [index, truth] : left.store.truths) {
    if (proof_context.mission.variables[index].kind == VariableKind::Momentary) {
      truth = {context.bool_val(false), context.bool_val(false)};
    }
  }
  for (const Observation& observation : monitor.observations) {
    const auto found = left.store.truths.find(observation.variable.index);
    if (found != left.store.truths.end()) {
      const bool is = observed(observation, outcome, left);
      found->second = {context.bool_val(is), context.bool_val(!is)};
    }
  }
  SymbolicState seen = moment;
  showTrueDepth(left, seen, proof_context);
  left.store = SymbolicTick(proof_context, relevance, moment.unknowns())
                   .execute(seen, monitor.step, std::move(left.store), left.mission_time);
  left.store.show(moment);
}

/// The depths at which a comparison with the true depth changes, as low as they may be.
class AwaitedDepths {
 public:
  explicit AwaitedDepths(const ProofContext& proof_context) : proof_context_(proof_context) {}

  void look(ExprId root) {
    forEachIn(proof_context_.mission, root, [&](const Expr& e) {
      if (isOrdering(e.op)) {
        compare(e.operands[0], e.op, e.operands[1]);
        compare(e.operands[1], mirrored(e.op), e.operands[0]);
      }
    });
  }

  [[nodiscard]] std::vector<double> found() const { return {depths_.begin(), depths_.end()}; }

 private:
  void compare(ExprId reading, Op op, ExprId limit) {
    const Expr& e = proof_context_.mission[reading];
    if (e.op != Op::Sensor || e.sensor != proof_context_.depth) {
      return;
    }
    const double lowest = proof_context_.intervals[limit.index].lowest;
    // The limit itself is on the other side of `<` and `>=`.
    const bool apart = op == Op::Less || op == Op::GreaterEqual;
    const double depth = apart ? std::nextafter(lowest, -kGreatestNumber) : lowest;
    if (depth > 0 && depth < kGreatestNumber) {
      depths_.insert(depth);
    }
  }

  const ProofContext& proof_context_;
  std::set<double> depths_;
};

}  // namespace

bool observes(const Monitor& monitor, StateId state) {
  return std::ranges::any_of(monitor.observations, [&](const Observation& one) {
    return one.kind != ObservationKind::Ended && one.state == state;
  });
}

std::vector<double> awaitedDepths(const Requirement& requirement,
                                  const ProofContext& proof_context) {
  AwaitedDepths depths(proof_context);
  forEachStatement(proof_context.mission, requirement.monitor.step,
                   [&](const Statement& s) { depths.look(s.value); });
  return depths.found();
}

namespace {

SafetyProperty always(const Requirement& requirement, const ProofContext& proof_context,
                      const ConeOfInfluence& relevance) {
  SafetyProperty watch;
  const ExprId condition = requirement.condition;
  if (requirement.monitor.step.valid()) {
    watch.every_tick = requirement.monitor.every_tick;
    watch.awaited_depths = awaitedDepths(requirement, proof_context);
    watch.observe = [&requirement, &proof_context, &relevance](
                        const Outcome* outcome, Configuration& left, SymbolicState& moment) {
      observe(requirement.monitor, outcome, left, moment, proof_context, relevance);
    };
  }
  watch.bad_at_tick = [condition, &proof_context](const Configuration& left,
                                                  SymbolicState& moment) {
    return std::optional(isFalse(condition, left, moment, proof_context));
  };
  return watch;
}

}  // namespace

bool reckonsWithDepth(const Requirement& requirement, const ProofContext& proof_context) {
  if (requirement.kind == RequirementKind::SurfacesEvery) {
    return true;
  }
  if (requirement.kind != RequirementKind::Always) {
    return false;
  }
  bool reads = readsDepth(requirement.condition, proof_context);
  forEachStatement(proof_context.mission, requirement.monitor.step, [&](const Statement& s) {
    reads = reads || readsDepth(s.value, proof_context);
  });
  return reads;
}

SafetyProperty safetyPropertyFor(const Requirement& requirement, z3::context& context,
                                 const ProofContext& proof_context,
                                 const ConeOfInfluence& relevance) {
  switch (requirement.kind) {
    case RequirementKind::Always:
      return always(requirement, proof_context, relevance);
    case RequirementKind::ExitWithin:
      return exitWithin(requirement.seconds, context);
    case RequirementKind::Reach:
      return reaching(requirement.state, context);
    case RequirementKind::NeverAfter:
      return neverAfter(requirement.state, requirement.after, context);
    case RequirementKind::SurfacesEvery:
      return surfacesEvery(requirement.seconds, context, proof_context);
    case RequirementKind::StackAtMost:
      break;
  }
  return {};
}

namespace {

ConeOfInfluence coneOf(const Requirement& requirement, const ProofContext& proof_context,
                       bool vehicle) {
  std::vector<ExprId> asked;
  if (requirement.condition.valid()) {
    asked.push_back(requirement.condition);
  }
  return relevanceFor(proof_context.mission, asked, vehicle);
}

/// A climb is counted from when its state became current.
ConeOfInfluence withClimbs(ConeOfInfluence cone, const Requirement& requirement,
                           const ProofContext& proof_context) {
  cone.resume_time = cone.resume_time || !awaitedDepths(requirement, proof_context).empty();
  return cone;
}

}  // namespace

ConeOfInfluence relevanceOf(const Requirement& requirement, const ProofContext& proof_context) {
  return withClimbs(
      coneOf(requirement, proof_context, reckonsWithDepth(requirement, proof_context)), requirement,
      proof_context);
}

ConeOfInfluence withVehicle(const Requirement& requirement, const ProofContext& proof_context) {
  return withClimbs(coneOf(requirement, proof_context, true), requirement, proof_context);
}

ConeOfInfluence relevanceWithin(const Requirement& requirement, const ProofContext& proof_context) {
  return coneOf(requirement, proof_context, reckonsWithDepth(requirement, proof_context));
}

bool readsDepth(const ConeOfInfluence& relevance, const ProofContext& proof_context) {
  for (size_t i = 0; i < relevance.expressions.size(); ++i) {
    const Expr& e = proof_context.mission.exprs[i];
    if (relevance.expressions[i] && e.op == Op::Sensor && proof_context.depth == e.sensor) {
      return true;
    }
  }
  return false;
}

}  // namespace glider::ir::prove
