// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `longWatches`: `held` and windows that need longer than their state can last, so that
// they are never true, or never known (GL3116). In: the longest stay in each state (stayOf), and
// for windows of states that wait for a return the end bound. Certain, by the rules in the comment
// of WatchCheck. A stay without a bound gives no report. What is reported already (Proof::said) is
// left out.

#include "ir/core/ops.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/leaving.h"
#include "ir/prove/abstract/watch_times.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/passes.h"
#include "ir/verify/intervals.h"
#include "support/diagnostics/ids/verification.h"

#include <map>
#include <set>
#include <tuple>
#include <vector>

namespace glider::ir::prove {
namespace {

/// Looks for a `held` and for windows over time that need longer than their state can last. Both
/// begin at the earliest when their state is entered, a `held` also when it is resumed (E3, E5,
/// W9), and are neither true nor known before their time is over (B5, W6).
class WatchCheck {
 public:
  explicit WatchCheck(Proof& proof)
      : proof_(proof),
        proof_context_(proof.proof_context),
        m_(proof_context_.mission),
        values_(anyValues(m_)),
        always_{neverPrevented(m_), false} {}

  void run() {
    std::map<StateId, std::vector<uint32_t>> watched;
    for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
      const Temporal& temporal = m_.temporals[i];
      if (temporal.list != ListKind::Always && timeNeeded(proof_context_, temporal) > 0) {
        watched[temporal.state].push_back(i);
      }
    }
    idle_.assign(m_.temporals.size(), false);
    for (const auto& [state, temporals] : watched) {
      const double lasts = longestStay(state, temporals);
      for (const uint32_t i : temporals) {
        check(m_.temporals[i], lasts);
      }
    }
  }

 private:
  /// Since the state became current, s. The cases that wait for what takes longer do not keep the
  /// state: until then they do not fire, and by then it is left. So all are first assumed idle,
  /// then those that take longer than the state lasts, until nothing changes.
  double longestStay(StateId state, const std::vector<uint32_t>& temporals) {
    for (const uint32_t i : temporals) {
      // A window goes on while its state waits for a return.
      idle_[i] = m_.temporals[i].kind == TemporalKind::Held || !mayWait(m_, state);
    }
    double lasts = 0;
    for (bool changed = true; changed;) {
      lasts = stayOf(proof_context_, m_[state], always_, values_, &idle_).by;
      changed = false;
      for (const uint32_t i : temporals) {
        const bool idle = idle_[i] && timeNeeded(proof_context_, m_.temporals[i]) > lasts;
        changed = changed || idle != idle_[i];
        idle_[i] = idle;
      }
    }
    return lasts;
  }

  /// `lasts`: how long its state may, s.
  void check(const Temporal& temporal, double lasts) {
    const double needed = timeNeeded(proof_context_, temporal);
    const bool held = temporal.kind == TemporalKind::Held;
    if (needed > lasts && !held && mayWait(m_, temporal.state)) {
      const EndBound& end = proof_.ending.bound();
      lasts = end.by ? end.left_by[temporal.state.index] : kGreatestNumber;
    }
    const State& state = m_[temporal.state];
    const bool elsewhere = proof_.options.inLibrary(temporal.range);
    const support::SourceRange range = elsewhere ? state.profile.range : temporal.range;
    if (!(needed > lasts) || lasts <= 0 || proof_.said.cover(range) ||
        !told_.emplace(range.file, range.begin, temporal.state).second) {
      return;
    }
    proof_.diagnostics.report(support::diagnostics::longerThanState, range, durationOf(needed),
                              state.name, durationOf(lasts),
                              held ? "it is never true" : "its value is never known");
  }

  Proof& proof_;
  const ProofContext& proof_context_;
  const Mission& m_;
  Valuation values_;
  Interruptions always_;
  IdleTemporals idle_;
  std::set<std::tuple<uint32_t, uint32_t, StateId>> told_;
};

}  // namespace

void passes::longWatches(Proof& proof) {
  WatchCheck(proof).run();
}

}  // namespace glider::ir::prove
