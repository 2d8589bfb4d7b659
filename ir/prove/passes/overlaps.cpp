// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `overlaps`: two cases of a state with different targets that can be true on the same
// tick, so that their order decides. Out: lines of the report, with readings that make both true.
// One question to Z3 for each pair, in lists of at most kMostCases; what the answer says is
// evaluated before it is claimed. A line may be wrong where the question allows more than a flight
// does, as with windows and functions in C.

#include "ir/core/walk.h"
#include "ir/prove/context/control.h"
#include "ir/prove/encoding/confirmation.h"
#include "ir/prove/encoding/kept_assumptions.h"
#include "ir/prove/encoding/question.h"
#include "ir/prove/encoding/symbolic_state.h"
#include "ir/prove/passes.h"
#include "support/check.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace glider::ir::prove {
namespace {

/// For longer lists the pairs would be too many to read.
constexpr size_t kMostCases = 12;
constexpr size_t kMostOverlapStates = 50;

bool leadsAway(const Case& c) {
  return c.transition != Transition::Stay && c.transition != Transition::Done;
}

std::string wayOf(const Mission& m, const Case& c) {
  switch (c.transition) {
    case Transition::Goto:
      return fmt::format("`goto {}`", m[c.target].name);
    case Transition::Call:
      return fmt::format("`call {}`", m[c.target].name);
    case Transition::Return:
      return "`return`";
    case Transition::Exit:
      return "`exit`";
    case Transition::Stay:
    case Transition::Done:
      break;
  }
  CHECK(false, "it leads nowhere");
}

/// Looks for cases of a state that lead to different places and can be true on the same tick: their
/// order in the list then decides.
class OverlapCheck {
 public:
  explicit OverlapCheck(Proof& proof) : proof_(proof), m_(proof.proof_context.mission) {}

  void run() {
    for (uint32_t i = 0; i < m_.states.size() && m_.states.size() <= kMostOverlapStates; ++i) {
      const std::vector<Case>& cases = m_.states[i].cases;
      for (uint32_t a = 0; a < cases.size() && cases.size() <= kMostCases; ++a) {
        for (uint32_t b = a + 1; b < cases.size(); ++b) {
          compare({i}, a, b);
        }
      }
    }
  }

 private:
  [[nodiscard]] bool readsItsTime(ExprId guard) const {
    return anyIn(m_, guard,
                 [](const Expr& e) { return e.op == Op::StateTime || e.op == Op::ResumeTime; });
  }

  void compare(StateId state, uint32_t first, uint32_t second) {
    const Case& a = m_[state].cases[first];
    const Case& b = m_[state].cases[second];
    const bool same_way = a.transition == b.transition && a.target == b.target;
    const bool dead = proof_.dead.contains({state, first}) || proof_.dead.contains({state, second});
    const bool last_resort = m_[b.guard].op == Op::True || m_[a.guard].op == Op::True;
    const bool said = proof_.said.cover(m_[a.guard].range) || proof_.said.cover(m_[b.guard].range);
    if (!leadsAway(a) || !leadsAway(b) || same_way || dead || last_resort || said) {
      return;
    }
    Unknowns unknowns(proof_.context);
    SymbolicState moment(unknowns, proof_.proof_context);
    moment.relateRemainders();
    if (isNeverResumed(m_, state)) {
      moment.isNotResumed();
    }
    if (isEnteredOnlyAtStart(m_, state) && (readsItsTime(a.guard) || readsItsTime(b.guard))) {
      unknowns.require(moment.stateTime() == moment.missionTime());
    }
    Question question(proof_.context, proof_.checks, proof_.options.effort);
    question.add(moment.truth(a.guard).is_true && moment.truth(b.guard).is_true);
    keepAssumptions(moment);
    question.add(unknowns);
    if (question.ask() != Answer::Yes) {
      return;
    }
    const z3::model model = question.model();
    if (isConfirmed(model, moment, a.guard) && isConfirmed(model, moment, b.guard)) {
      proof_.findings.lines.push_back(
          {b.range,
           fmt::format("in `{}`, {} and {} can be true on the same tick: {}; {} fires first",
                       m_[state].name, wayOf(m_, a), wayOf(m_, b), describe(model, moment),
                       wayOf(m_, a))});
    }
  }

  Proof& proof_;
  const Mission& m_;
};

}  // namespace

void passes::overlaps(Proof& proof) {
  if (proof.options.report) {
    OverlapCheck(proof).run();
  }
}

}  // namespace glider::ir::prove
