// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/control.h"
#include "ir/prove/encoding/store.h"

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace glider::ir::prove {

/// What a running mission keeps of a temporal: whether the operand was true, and since when.
struct Watched {
  z3::expr was_true;
  z3::expr since;
};

/// A running mission between two ticks: its control and the terms that it keeps.
struct Configuration {
  Control control;
  z3::expr mission_time;
  std::vector<z3::expr> entered;  ///< of the waiting states, outermost first, then of the current
  z3::expr resumed;
  Store store;
  std::map<uint32_t, Watched> watched;  ///< `became` and `held`, by temporal
  std::vector<z3::expr> memory;         ///< what a question keeps for itself
};

/// A possible outcome of a tick: where it leads if `condition` holds.
struct Outcome {
  z3::expr condition;
  std::optional<Configuration> after;  ///< none: the mission has ended
  std::optional<Configuration> left;   ///< for a mission that has ended: what its last tick left
  ListKind list = ListKind::State;     ///< whose case made the transition
  std::optional<uint32_t> fired;       ///< its number; none: the state stays current
};

/// The cone of influence of a question; a tick leaves out everything else.
struct ConeOfInfluence {
  std::vector<bool> expressions;
  std::vector<bool> variables;
  std::vector<bool> temporals;
  bool vehicle = false;  ///< commands and the depth
  bool state_time = false;
  bool resume_time = false;
  /// Whether a state's profile and route are run: they set a variable in the cone, or give
  /// commands.
  std::vector<bool> profiles;
  std::vector<bool> routes;
};

/// How ticks follow each other.
enum class Pace : uint8_t {
  Single,  ///< the preceding tick was the last one
  Many     ///< any number of ticks has passed without a transition since
};

/// A tick at `now`, not before the configuration's time, with these `readings`: all its possible
/// outcomes. The vehicle has already moved.
class SymbolicTick {
 public:
  SymbolicTick(const ProofContext& proof_context, const ConeOfInfluence& relevance,
               Unknowns& unknowns)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        relevance_(relevance),
        unknowns_(unknowns) {}

  std::vector<Outcome> run(const Configuration& before, const z3::expr& now,
                           const SymbolicState& readings, Pace pace);
  /// The start of the mission: its variables, `always`, the first state.
  Configuration start(Configuration before, const SymbolicState& readings);
  /// What entering the state that is current leaves, as goto and call do: its variables, what it
  /// watches, its entry. `moment` has the readings of the tick.
  Configuration enter(Configuration before, SymbolicState moment);
  /// What the statements of a block leave of `store`.
  Store execute(SymbolicState& moment, BlockId block, Store store, const z3::expr& now);

 private:
  struct Run;  // a tick in progress (tick.cpp)

  void advance(Run& run, Pace pace);
  void advanceOne(Run& run, TemporalId id, Pace pace);
  bool tryList(Run& run, ListKind list, const std::vector<Case>& cases);
  void fire(Run& run, ListKind list, uint32_t number, const Case& c, const z3::expr& condition,
            const Store& after_action);
  void pass(const SymbolicState& before, const Case& c, Store& store);
  void runActivity(Run& run, const Activity& activity, bool relevant);

  Store executeOne(SymbolicState& moment, const Statement& statement, Store store,
                   const z3::expr& now);
  /// A rounded value stays within the interval of the exact one.
  void bound(SymbolicState& moment, const NumberTerm& term, const Interval& interval);
  NumberTerm rounded(SymbolicState& moment, ExprId value);
  void assign(SymbolicState& moment, VariableId variable, ExprId value, Store& store, bool start);
  TruthTerm heldFor(SymbolicState& moment, const Temporal& temporal, const TruthTerm& operand,
                    const z3::expr& since);
  void startWatching(SymbolicState& moment, ListKind list, StateId state,
                     Configuration& configuration);
  Configuration resume(Configuration before, SymbolicState moment);
  void runEntry(SymbolicState& moment, const Activity& activity, bool relevant,
                Configuration& after);

  const ProofContext& proof_context_;
  const Mission& m_;
  const ConeOfInfluence& relevance_;
  Unknowns& unknowns_;
};

}  // namespace glider::ir::prove
