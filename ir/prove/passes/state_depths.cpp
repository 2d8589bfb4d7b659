// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `stateDepths`: conditions on `depth`, in the cases of a state and its lines `sample`,
// that do not fit the depths that the state commands: never true (GL3115), or true only above all
// of them (GL3120). In: the deepest and the shallowest commands of each state; out: warnings, and
// Proof::said. GL3115 is certain in the environment model (V2 to V4, V7); GL3120 is a hint, because
// a vehicle that comes from above passes that depth. Cases of `always` are not checked: they often
// guard against failures.

#include "ir/prove/abstract/state_depths.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/shallowest_command.h"
#include "ir/prove/passes.h"
#include "ir/verify/intervals.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace glider::ir::prove {
namespace {

constexpr double kWithoutEnd = std::numeric_limits<double>::infinity();

/// Looks for conditions on the depth that do not fit the depths to which a state's commands lead.
/// Only the state's own cases, and where it reads its instruments: a case of `always` is for all
/// states, and often for failures.
class DepthCheck {
 public:
  explicit DepthCheck(Proof& proof)
      : proof_(proof),
        proof_context_(proof.proof_context),
        m_(proof_context_.mission),
        values_(anyValues(m_)) {}

  void run() {
    if (!proof_context_.depth || proof_context_.sensors[proof_context_.depth->index].empty) {
      return;
    }
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      for (uint32_t k = 0; k < m_.states[i].cases.size(); ++k) {
        if (!proof_.dead.contains({StateId{i}, k}) && readsDepth(m_.states[i].cases[k].guard)) {
          checkDeepest({i}, m_.states[i].cases[k].guard);
          checkShallowest({i}, m_.states[i].cases[k]);
        }
      }
      for (const Sampling& sampling : m_.states[i].sampling) {
        checkSampling({i}, sampling.code);
      }
    }
  }

 private:
  /// Also in what a temporal watches: an expression that comes before it.
  [[nodiscard]] bool readsDepth(ExprId root) const {
    std::vector<ExprId> open{root};
    bool reads = false;
    while (!open.empty() && !reads) {
      const ExprId next = open.back();
      open.pop_back();
      forEachIn(m_, next, [&](const Expr& e) {
        reads = reads || (e.op == Op::Sensor && e.sensor == *proof_context_.depth);
        if (e.op == Op::Temporal) {
          open.push_back(m_[e.temporal].operand);
        }
      });
    }
    return reads;
  }

  /// Whether a condition may be true if all readings of the depth so far lie in `depths`.
  [[nodiscard]] bool mayBeTrue(ExprId condition, const Interval& depths) const {
    constexpr Interval kEver{0, kGreatestNumber, false};
    const AssumedReading sight{*proof_context_.depth, depths, true};
    return AbstractEvaluator(proof_context_, values_, {kEver, kEver, kEver}, sight)
        .truth(condition)
        .is_true;
  }

  [[nodiscard]] const Interval& allDepths() const {
    return proof_context_.sensors[proof_context_.depth->index];
  }

  /// The alternatives of a condition are checked one by one: the others may well be true.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void checkDeepest(StateId state, ExprId condition) {
    const Expr& e = m_[condition];
    if (e.op == Op::Or) {
      checkDeepest(state, e.operands[0]);
      checkDeepest(state, e.operands[1]);
      return;
    }
    const double deepest = deepestOf(state);
    const Interval& all = allDepths();
    const double reading =
        std::nextafter(deepest + proof_context_.platform.world.depth_error_m, kWithoutEnd);
    if (!(reading < all.highest) || mayBeTrue(condition, {all.lowest, reading, false}) ||
        !mayBeTrue(condition, all)) {
      return;
    }
    proof_.said.add(e.range);
    proof_.diagnostics.report(
        support::diagnostics::neverTrueInState, e.range, m_[state].name,
        fmt::format("commands lead the vehicle at most {:.4g} m deep there, and a reading of "
                    "`{}` is wrong by at most {:.4g} m",
                    deepest, m_[*proof_context_.depth].name,
                    proof_context_.platform.world.depth_error_m));
  }

  /// Where an instrument reads: `sample … below 60 m` of a state that stays above.
  void checkSampling(StateId state, ExprId code) {
    std::vector<ExprId> open{code};
    while (!open.empty()) {
      const Expr& e = m_[open.back()];
      open.pop_back();
      if (e.op != Op::Select) {
        continue;
      }
      const ExprId condition = e.operands[0];
      if (m_[condition].op != Op::Known && readsDepth(condition)) {
        checkDeepest(state, condition);
      }
      open.push_back(e.operands[1]);
      open.push_back(e.operands[2]);
    }
  }

  double deepestOf(StateId state) {
    if (deepest_.empty()) {
      deepest_ = deepestByState(proof_context_);
    }
    return deepest_[state.index];
  }

  /// The cases of a state are checked one after the other.
  const std::optional<Shallowest>& shallowestOf(StateId state) {
    if (!shallowest_) {
      shallowest_.emplace(proof_context_);
    }
    if (found_of_ != state) {
      found_of_ = state;
      found_ = shallowest_->of(state);
    }
    return found_;
  }

  /// A case that leaves the state above all depths that the state commands.
  void checkShallowest(StateId state, const Case& c) {
    const Interval& all = allDepths();
    if (c.transition == Transition::Stay || !mayBeTrue(c.guard, all)) {
      return;
    }
    const std::optional<Shallowest>& found = shallowestOf(state);
    const double reading = found ? std::nextafter(found->reading_m, -kWithoutEnd) : all.lowest;
    if (reading > all.lowest && reading < all.highest &&
        !mayBeTrue(c.guard, {reading, all.highest, false})) {
      proof_.diagnostics.report(support::diagnostics::aboveCommands, m_[c.guard].range,
                                m_[state].name, fmt::format("{:.4g} m", found->target_m));
    }
  }

  Proof& proof_;
  const ProofContext& proof_context_;
  const Mission& m_;
  Valuation values_;
  std::vector<double> deepest_;  ///< by state; empty: not computed yet
  std::optional<ShallowestCommands> shallowest_;
  std::optional<StateId> found_of_;  ///< the state that `found_` is of
  std::optional<Shallowest> found_;
};

}  // namespace

void passes::stateDepths(Proof& proof) {
  DepthCheck(proof).run();
}

}  // namespace glider::ir::prove
