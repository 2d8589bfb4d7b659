// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/any_moment.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/verify/intervals.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace glider::ir::prove {
namespace {

/// More groups of states than this are not asked about apart.
constexpr size_t kMostGroups = 40;

/// A moment within these bounds: the depth is the vehicle's true depth, as conditions of
/// requirements read it.
class BoundedMoment {
 public:
  BoundedMoment(const ProofContext& proof_context, const StateBounds& bounds, Unknowns& unknowns)
      : m_(proof_context.mission), state_(unknowns, proof_context) {
    z3::context& context = unknowns.context();
    within(state_.missionTime(), bounds.earliest, bounds.latest);
    within(state_.stateTime(), 0, bounds.state_time);
    within(state_.resumeTime(), 0, bounds.resume_time);
    for (const ExprId id : m_.conditions) {
      unknowns.require(state_.truth(id).is_true);
    }
    if (const auto& depth = proof_context.depth) {
      (void)state_.age(*depth);  // of the reading, which may be unknown where the depth is not
      const z3::expr real = unknowns.real("true depth");
      unknowns.require(real >= 0);
      if (std::isfinite(bounds.depth)) {
        unknowns.require(real <= state_.real(bounds.depth));
      }
      state_.setReading(*depth, NumberTerm{real, context.bool_val(true), 0});
    }
    state_.forget();
  }

  TruthTerm truth(ExprId id) { return state_.truth(id); }

 private:
  void within(const z3::expr& clock, double lowest, double highest) {
    state_.unknowns().require(clock >= state_.real(lowest));
    if (highest < kGreatestNumber) {
      state_.unknowns().require(clock <= state_.real(highest));
    }
  }

  const Mission& m_;
  SymbolicState state_;
};

/// What a condition can tell apart: states are asked about together if they do not differ in it.
StateBounds projected(const Mission& m, ExprId condition, const ProofContext& proof_context,
                      const StateBounds& bounds, const StateBounds& hull) {
  const auto reads = [&](auto is) { return anyIn(m, condition, is); };
  StateBounds kept = hull;
  const bool age = reads([](const Expr& e) { return e.op == Op::Age; });
  if (age || reads([](const Expr& e) { return groupOf(e.op) == OpGroup::Clock; })) {
    kept = bounds;
    kept.depth = hull.depth;
  }
  const bool depth = reads([&](const Expr& e) {
    return e.op == Op::Sensor && proof_context.depth && e.sensor == *proof_context.depth;
  });
  kept.depth = depth ? bounds.depth : hull.depth;
  return kept;
}

}  // namespace

Answer AnyMoment::falseWithin(ExprId condition, const StateBounds& bounds, unsigned effort,
                              Budget& budget) {
  Unknowns unknowns(context_);
  BoundedMoment moment(proof_context_, bounds, unknowns);
  Question question(context_, budget, effort);
  question.add(moment.truth(condition).is_false);
  for (const ExprId known : known_) {
    question.add(!moment.truth(known).is_false);
  }
  for (const Fact& fact : unknowns.facts()) {
    question.add(fact.holds);
  }
  return question.ask();
}

bool AnyMoment::neverFalse(ExprId condition, unsigned effort, Budget& budget) {
  const StateBounds hull = hullOf(bounds_);
  if (budget.isUsedUp()) {
    return false;
  }
  if (falseWithin(condition, hull, effort, budget) == Answer::No) {
    return true;
  }
  std::set<StateBounds> groups;
  for (const StateBounds& bounds : bounds_) {
    groups.insert(projected(proof_context_.mission, condition, proof_context_, bounds, hull));
    if (groups.size() > kMostGroups) {
      return false;
    }
  }
  return !groups.empty() && groups.begin()->latest > 0 && !groups.contains(hull) &&
         std::ranges::all_of(groups, [&](const StateBounds& bounds) {
           return falseWithin(condition, bounds, effort, budget) == Answer::No;
         });
}

}  // namespace glider::ir::prove
