// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `exitsNotTried`: a case with `stay` that can keep the cases below it, and so the end of
// the mission, from being tried (GL3140). In: the verdicts (not needed if `exit within` is proved),
// the end bound, and the cases that may fire. Each suspect costs one or two more end bounds, so at
// most kMostSuspects are checked. A hint: that there is no bound with the case does not prove that
// a flight never ends.

#include "ir/core/mission_writer.h"
#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <algorithm>
#include <vector>

namespace glider::ir::prove {
namespace {

/// More are not checked: each takes a search for the end.
constexpr size_t kMostSuspects = 8;

/// A case with `stay` above one that leads on.
struct Suspect {
  CasePlace place;
  const Case* stays = nullptr;
  const Case* leads = nullptr;
};

bool isClock(const Mission& m, ExprId id) {
  return groupOf(m[id].op) == OpGroup::Clock;
}

/// Whether a comparison is true from some time on, as far as a clock decides it.
bool staysTrue(const Mission& m, const Expr& e) {
  const auto clocks = [&](ExprId id) {
    return anyIn(m, id, [](const Expr& x) { return groupOf(x.op) == OpGroup::Clock; });
  };
  const bool above = e.op == Op::Greater || e.op == Op::GreaterEqual;
  const bool below = e.op == Op::Less || e.op == Op::LessEqual;
  const bool left = clocks(e.operands[0]);
  const bool right = clocks(e.operands[1]);
  return (!left && !right) || (above && isClock(m, e.operands[0]) && !right) ||
         (below && isClock(m, e.operands[1]) && !left);
}

/// Whether the condition may be true for ever: as long as readings allow, or once a clock is past a
/// time. It reads nothing that `set` changes.
bool mayHoldForEver(const Mission& m, ExprId guard) {
  const auto is = [&](auto... groups) {
    return anyIn(m, guard, [&](const Expr& e) { return ((groupOf(e.op) == groups) || ...); });
  };
  const bool comes_to_an_end = anyIn(m, guard, [&](const Expr& e) {
    return e.op == Op::Not || (groupOf(e.op) == OpGroup::Comparison && !staysTrue(m, e));
  });
  const bool by_clock = is(OpGroup::Clock) && !comes_to_an_end;
  return (by_clock || (is(OpGroup::Sensor) && !is(OpGroup::Clock))) &&
         !is(OpGroup::Variable, OpGroup::Temporal, OpGroup::Age, OpGroup::Call);
}

void suspectsOf(const Proof& proof, StateId state, const std::vector<Case>& cases,
                std::vector<Suspect>& suspects) {
  for (uint32_t i = 0; i < cases.size(); ++i) {
    const bool suspect = cases[i].transition == Transition::Stay &&
                         !proof.dead.contains({state, i}) &&
                         mayHoldForEver(proof.proof_context.mission, cases[i].guard);
    const auto leads = std::ranges::find_if(cases.begin() + i, cases.end(), [](const Case& c) {
      return c.transition != Transition::Stay;
    });
    if (suspect && leads != cases.end()) {
      suspects.push_back({{state, i}, &cases[i], &*leads});
    }
  }
}

/// Whether the clocks end the mission if the suspects never fire, except `kept`.
bool endsWithout(const Proof& proof, const std::vector<Suspect>& suspects, const Suspect* kept) {
  Mission without = proof.proof_context.mission;
  const ExprId never = MissionWriter(without).truth(false);
  for (const Suspect& suspect : suspects) {
    if (&suspect != kept) {
      auto& cases = suspect.place.state.valid() ? without.states[suspect.place.state.index].cases
                                                : without.always;
      cases[suspect.place.number].guard = never;
    }
  }
  const ProofContext context(without, proof.proof_context.platform);
  return boundOf(context.withoutPowerCuts(), kLongestMission, Goal::Exit).by.has_value();
}

/// Whether `exit within` is proved, perhaps under assumptions: its line names them.
bool isProvedToEnd(const Proof& proof) {
  return std::ranges::any_of(proof.findings.requirements, [&](const RequirementVerdict& verdict) {
    const Requirement& required = proof.proof_context.mission.requirements[verdict.requirement];
    return required.kind == RequirementKind::ExitWithin && verdict.verdict == Verdict::Proved;
  });
}

}  // namespace

/// Looks for a case with `stay` that keeps the mission from its end: with it the mission may last
/// for ever, and without it the clocks end the mission.
void passes::exitsNotTried(Proof& proof) {
  if (isProvedToEnd(proof)) {
    return;
  }
  const Mission& m = proof.proof_context.mission;
  std::vector<Suspect> suspects;
  suspectsOf(proof, {}, m.always, suspects);
  for (uint32_t s = 0; s < m.states.size(); ++s) {
    suspectsOf(proof, {s}, m.states[s].cases, suspects);
  }
  if (suspects.empty() || suspects.size() > kMostSuspects) {
    return;
  }
  const EndBound& end = proof.ending.boundWithoutPowerCuts();
  if (end.by || !end.stays.valid() || !endsWithout(proof, suspects, nullptr)) {
    return;
  }
  for (const Suspect& suspect : suspects) {
    if (!proof.said.concern(suspect.stays->range) && !endsWithout(proof, suspects, &suspect)) {
      proof.diagnostics.report(support::diagnostics::exitNotTried, suspect.stays->range)
          .note(suspect.leads->range, "this case is not tried while that condition is true");
    }
  }
}

}  // namespace glider::ir::prove
