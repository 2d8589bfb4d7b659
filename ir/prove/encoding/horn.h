// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/layout.h"
#include "ir/prove/encoding/question.h"
#include "ir/prove/encoding/run.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace glider::ir::prove {

/// What a question about all runs asks of each step. Every function sees the configuration with the
/// memory that the question keeps in it.
struct SafetyProperty {
  std::vector<z3::sort> memory;
  /// Memory of the start; after time has passed; after a transition (Outcome) of a tick.
  std::function<void(Configuration& start)> begin;
  std::function<void(const Configuration& before, Configuration& after)> elapse;
  std::function<void(const Configuration& before, const Outcome& outcome, Configuration& after)>
      move;
  /// What no tick must leave, the start and the last one included: seen with its readings.
  std::function<std::optional<z3::expr>(const Configuration& left, SymbolicState& moment)>
      bad_at_tick;
  /// What must not be after a tick, whatever it read.
  std::function<std::optional<z3::expr>(const Configuration& now)> bad_after;
  /// A transition that must not be made.
  std::function<std::optional<z3::expr>(const Configuration& before, const Outcome& outcome)>
      bad_move;
};

struct RunsAnswer {
  Answer bad = Answer::Unknown;  ///< whether some run is bad: No is a proof that none is
  std::optional<Run> run;        ///< after Yes
  std::string trouble;           ///< after Unknown: what was tried
};

/// Asks Z3's Spacer about all runs of the mission, from the start on: the mission as a pushdown
/// system over reals, one pair of predicates for each call stack. Time passes in steps of any
/// length, but not past a moment at which a condition of clocks and variables turns, by more than
/// the longest gap between two ticks.
RunsAnswer askAboutRuns(z3::context& context, const ProofContext& proof_context,
                        const ConeOfInfluence& relevance, const SafetyProperty& watch,
                        unsigned effort);

}  // namespace glider::ir::prove
