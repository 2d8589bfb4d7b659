// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/certificate.h"
#include "ir/prove/context/state_bounds.h"
#include "ir/prove/encoding/layout.h"
#include "ir/prove/encoding/question.h"
#include "ir/prove/encoding/run.h"
#include "ir/prove/encoding/scope.h"

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glider::ir::prove {

/// How a search makes lemmas of the conflicts that it finds; each is checked before it counts.
enum class Lemmas : uint8_t {
  Farkas,      ///< one sum of the inequalities of a conflict
  Elimination  ///< several, by Gaussian elimination: more for sums of times
};

/// A safety property: what a question about all traces checks at each step. Every function receives
/// the configuration with the memory that the question keeps in it.
struct SafetyProperty {
  std::vector<MemoryTerm> memory;
  /// Sets the memory at the start; after time has passed; after a transition (Outcome) of a tick.
  std::function<void(Configuration& start)> begin;
  std::function<void(const Configuration& before, Configuration& after)> elapse;
  std::function<void(const Configuration& before, const Outcome& outcome, Configuration& after)>
      move;
  /// What a monitor does at the end of a start or tick, in what that leaves: `outcome` is empty for
  /// the start. It sets variables of `left`, as `moment` sees the tick.
  std::function<void(const Outcome* outcome, Configuration& left, SymbolicState& moment)> observe;
  /// Whether each tick of a trace is followed: otherwise a step may stand for several ticks.
  bool every_tick = false;
  /// The depths (m) that the property waits for. A climb does not pass one by more than the longest
  /// gap between two ticks without a tick.
  std::vector<double> awaited_depths;
  /// What is known of each state without the question; empty: nothing. It says nothing about what
  /// is asked: the search is shorter with it.
  std::span<const StateBounds> known;
  /// Part of the mission, if the question does not follow all of it; then only a proof is an
  /// answer.
  std::optional<Scope> scope = {};
  Lemmas lemmas = Lemmas::Farkas;
  /// A condition that no tick may leave, including the start and the last tick: checked with its
  /// readings.
  std::function<std::optional<z3::expr>(const Configuration& left, SymbolicState& moment)>
      bad_at_tick;
  /// A condition that must not hold after a tick, for any readings.
  std::function<std::optional<z3::expr>(const Configuration& now)> bad_after;
  /// The condition of a transition that must not be made.
  std::function<std::optional<z3::expr>(const Configuration& before, const Outcome& outcome)>
      bad_move;
};

struct RunsAnswer {
  Answer bad = Answer::Unknown;  ///< whether some trace is bad: No is a proof that none is
  std::optional<Run> run;        ///< after Yes
  std::string trouble;           ///< after Unknown: what was attempted
  uint64_t steps = 0;            ///< what it took, in Z3's own count
  /// After No, with `keep_invariants`: what holds after each tick, for each call configuration.
  /// Together they are inductive.
  std::vector<certify::Invariant> invariants = {};
};

/// Asks Z3's Spacer about all traces of the mission, from the start on. The mission is a pushdown
/// system over reals, with one pair of predicates for each call stack. Time passes in steps of any
/// length, but a step may pass a change of a condition of clocks and variables, or the time from
/// which a climb has certainly led to a depth that the property waits for, by at most the longest
/// gap between two ticks.
RunsAnswer askAboutRuns(z3::context& context, const ProofContext& proof_context,
                        const ConeOfInfluence& relevance, const SafetyProperty& watch,
                        unsigned effort, bool keep_invariants = false);

}  // namespace glider::ir::prove
