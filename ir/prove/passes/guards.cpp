// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `guards`: cases that never fire (GL3101), that always fire (GL3102), or that earlier
// cases always hide (GL3103). In: every list of cases; out: warnings, Proof::dead and
// Proof::hidden, on which later passes and the marks of `glidercc graph` rest. Certain for one tick
// with any readings and any values of variables; what one tick implies for the next is ignored, so
// errors may be missed. Sampling answers most questions, Z3 the others. Without budget a case
// counts as one that may fire.

#include "ir/prove/encoding/question.h"
#include "ir/prove/encoding/reasons.h"
#include "ir/prove/encoding/sampling.h"
#include "ir/prove/passes.h"
#include "ir/verify/value_text.h"
#include "support/counted.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>

namespace glider::ir::prove {
namespace {

bool leavesState(Transition transition) {
  return transition == Transition::Goto || transition == Transition::Call ||
         transition == Transition::Return || transition == Transition::Exit;
}

bool isConstant(const Expr& e) {
  return e.op == Op::True || e.op == Op::False;
}

/// What was found out about one case.
struct GuardVerdict {
  bool never = false;
  bool always = false;
  bool hidden = false;
  std::vector<Fact> facts;          ///< why
  std::vector<uint32_t> hidden_by;  ///< numbers of earlier cases
};

class GuardCheck {
 public:
  explicit GuardCheck(Proof& proof) : proof_(proof), m_(proof.proof_context.mission) {}

  void run() {
    report(StateId(), m_.always, "`always`");
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      const State& state = m_.states[i];
      report({i}, state.cases, fmt::format("state `{}`", state.name));
      gather(state.profile);
      gather(state.route);
    }
    reportBehaviours();
    if (proof_.options.report && unchecked_ > 0) {
      proof_.findings.lines.push_back(
          {{},
           fmt::format(
               "whether {} can fire was not checked: all checks together reached their limit "
               "(--effort)",
               support::counted(unchecked_, "case"))});
    }
  }

 private:
  /// A behaviour's case in all its uses: depending on the arguments, it may be idle in some.
  struct Uses {
    const std::vector<Case>* list = nullptr;  ///< of the first use
    uint32_t number = 0;
    GuardVerdict verdict;
    bool everywhere = true;  ///< idle in all
  };

  std::vector<GuardVerdict> judge(const std::vector<Case>& cases) {
    std::vector<GuardVerdict> verdicts(cases.size());
    const std::vector<SamplingResult> seen = tryOut(proof_.proof_context, cases);
    for (uint32_t i = 0; i < cases.size(); ++i) {
      if (seen[i].first && seen[i].idle) {
        continue;
      }
      if (proof_.checks.isUsedUp()) {
        ++unchecked_;
      } else {
        verdicts[i] = judge(cases, i, verdicts, seen[i]);
      }
    }
    return verdicts;
  }

  /// Asks the solver what was not seen.
  GuardVerdict judge(const std::vector<Case>& cases, uint32_t number,
                     const std::vector<GuardVerdict>& earlier, const SamplingResult& seen) {
    GuardVerdict verdict;
    Unknowns unknowns(proof_.context);
    SymbolicState moment(unknowns, proof_.proof_context);
    const TruthTerm guard = moment.truth(cases[number].guard);
    if (!seen.fires) {
      Question never(proof_.context, proof_.checks, proof_.options.effort);
      never.add(unknowns);
      never.add(guard.is_true);
      verdict.never = never.ask() == Answer::No;
      if (verdict.never) {
        verdict.facts = never.neededFacts();
        return verdict;
      }
    }
    if (!seen.first) {
      judgeHidden(cases, number, earlier, verdict);
    }
    if (seen.idle) {
      return verdict;
    }
    Question always(proof_.context, proof_.checks, proof_.options.effort);
    always.add(unknowns);
    always.add(!guard.is_true);
    verdict.always = !verdict.hidden && always.ask() == Answer::No;
    if (verdict.always) {
      verdict.facts = always.neededFacts();
    }
    return verdict;
  }

  void judgeHidden(const std::vector<Case>& cases, uint32_t number,
                   const std::vector<GuardVerdict>& earlier, GuardVerdict& verdict) {
    Unknowns unknowns(proof_.context);
    SymbolicState moment(unknowns, proof_.proof_context);
    Question question(proof_.context, proof_.checks, proof_.options.effort);
    question.add(moment.truth(cases[number].guard).is_true);
    for (uint32_t i = 0; i < number; ++i) {
      // A case of `always` does not fire while its target is current or waits.
      const bool may_be_kept = &cases == &m_.always && cases[i].target.valid();
      if (!earlier[i].never && !may_be_kept) {
        question.add(!moment.truth(cases[i].guard).is_true, i);
      }
    }
    question.add(unknowns);
    verdict.hidden = number > 0 && question.ask() == Answer::No;
    if (verdict.hidden) {
      verdict.hidden_by = question.neededNames();
      verdict.facts = question.neededFacts();
    }
  }

  void report(StateId state, const std::vector<Case>& cases, const std::string& where) {
    const std::vector<GuardVerdict> verdicts = judge(cases);
    for (uint32_t i = 0; i < cases.size(); ++i) {
      if (verdicts[i].never || verdicts[i].hidden) {
        proof_.dead.insert({state, i});
        if (verdicts[i].hidden) {
          proof_.hidden.insert({state, i});
        }
      }
      if (!cases[i].implied) {
        report(cases, i, verdicts[i], where);
      }
    }
  }

  void report(const std::vector<Case>& cases, uint32_t number, const GuardVerdict& verdict,
              const std::string& where) {
    const Case& c = cases[number];
    const support::SourceRange range = m_[c.guard].range;
    if (verdict.never || verdict.hidden || verdict.always) {
      proof_.said.add(range);
    }
    if (verdict.never) {
      auto warning = proof_.diagnostics.report(support::diagnostics::guardNeverTrue, range);
      if (const std::string better = positive(m_[c.guard]); !better.empty()) {
        warning.hint(better);
      }
      noteReasons(warning, m_, verdict.facts, range);
    } else if (verdict.hidden) {
      auto warning = proof_.diagnostics.report(support::diagnostics::caseHidden, range);
      for (const uint32_t earlier : verdict.hidden_by) {
        warning.note(m_[cases[earlier].guard].range, "this earlier case fires first");
      }
      noteReasons(warning, m_, verdict.facts, range);
    } else if (verdict.always && leavesState(c.transition) && !isConstant(m_[c.guard])) {
      auto warning = proof_.diagnostics.report(support::diagnostics::guardAlwaysTrue, range, where);
      noteReasons(warning, m_, verdict.facts, range);
    }
  }

  /// `depth < -20 m`, of a reading that is never negative: what to write; empty for any other
  /// condition.
  [[nodiscard]] std::string positive(const Expr& guard) const {
    if (guard.op != Op::Less && guard.op != Op::LessEqual) {
      return "";
    }
    const Expr& left = m_[guard.operands[0]];
    const Interval& reading = proof_.proof_context.intervals[guard.operands[0].index];
    const Interval& limit = proof_.proof_context.intervals[guard.operands[1].index];
    const bool below = left.op == Op::Sensor && !reading.empty && reading.lowest >= 0 &&
                       !limit.empty && limit.lowest == limit.highest && limit.highest < 0;
    return below
               ? fmt::format("`{0}` is never negative: write `{0} {1} {2}`", m_[left.sensor].name,
                             guard.op == Op::Less ? ">" : ">=", withUnit(-limit.highest, left.type))
               : "";
  }

  void gather(const Activity& activity) {
    if (activity.cases.empty() || proof_.options.inLibrary(activity.cases.front().range)) {
      return;
    }
    const std::vector<GuardVerdict> verdicts = judge(activity.cases);
    for (size_t i = 0; i < verdicts.size(); ++i) {
      const Case& c = activity.cases[i];
      Uses& uses = behaviours_[{c.range.file, c.range.begin}];
      uses.everywhere = uses.everywhere && (verdicts[i].never || verdicts[i].hidden);
      if (uses.list == nullptr) {
        uses.list = &activity.cases;
        uses.number = static_cast<uint32_t>(i);
        uses.verdict = verdicts[i];
      }
    }
  }

  void reportBehaviours() {
    for (const auto& [place, uses] : behaviours_) {
      if (uses.everywhere) {
        report(*uses.list, uses.number, uses.verdict, "");
      }
    }
  }

  Proof& proof_;
  const Mission& m_;
  size_t unchecked_ = 0;  ///< cases, when the budget was used up
  std::map<std::pair<uint32_t, uint32_t>, Uses> behaviours_;  ///< by file and place
};

}  // namespace

void passes::guards(Proof& proof) {
  GuardCheck(proof).run();
}

}  // namespace glider::ir::prove
