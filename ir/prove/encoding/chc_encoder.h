// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/horn.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace glider::ir::prove {

/// Before or after a tick.
enum class Side : uint8_t {
  Due,  ///< time has passed
  Done  ///< the tick is over
};

/// A predicate: where traces can be.
struct Place {
  Control control;
  Side side = Side::Due;
  auto operator<=>(const Place&) const = default;
};

/// A constrained Horn clause: from a place, if `condition` holds for its row, to another place or
/// to a bad state.
struct Rule {
  std::optional<Place> from;  ///< none: the start
  std::optional<Place> to;    ///< none: a bad state
  std::vector<z3::expr> from_row;
  std::vector<z3::expr> to_row;
  z3::expr condition;
  std::vector<z3::expr> unknowns;  ///< all unknowns of the rule
  bool tick = false;
  std::optional<Configuration> before;  ///< of a rule with `from`
  std::optional<Configuration> after;   ///< of a rule with `to`, and of a bad tick
  std::map<uint32_t, NumberTerm> readings;
};

/// Encodes a mission as constrained Horn clauses, from the start on, for each call stack that it
/// can have.
class ChcEncoder {
 public:
  ChcEncoder(z3::context& context, const ProofContext& proof_context,
             const ConeOfInfluence& relevance, const SafetyProperty& watch)
      : context_(context),
        proof_context_(proof_context),
        m_(proof_context.mission),
        relevance_(relevance),
        watch_(watch),
        layout_(proof_context, relevance, watch_.memory, watch_.scope ? &*watch_.scope : nullptr) {}

  /// False if there are too many call stacks.
  bool run();
  [[nodiscard]] const std::vector<Rule>& rules() const { return rules_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }

 private:
  void begin();
  void elapse(const Control& control);
  void tick(const Control& control);
  void badAfter(const Control& control);
  /// What a mission may do that is in a state which is not followed (elsewhere.cpp).
  void leaveElsewhere(const Control& control);
  enum class Way : uint8_t { Stays, Ends, Enters };
  void stepElsewhere(const Control& from, const Control& to, Way way);
  /// Whether no case of `always` must have led from elsewhere to a state that is followed.
  z3::expr isNotLedAway(SymbolicState& moment) const;
  /// Whether a case elsewhere that ends the mission may fire.
  z3::expr mayEnd(SymbolicState& moment) const;
  [[nodiscard]] Configuration anywhere(const Control& control, const Configuration& before,
                                       Unknowns& unknowns) const;
  /// Whether all is followed that is known of where a trace can go.
  [[nodiscard]] bool isFine() const { return !watch_.scope || watch_.scope->fine; }
  /// A configuration that is not followed is only known to be elsewhere.
  void project(Rule& rule, Unknowns& unknowns) const;
  /// What a start or tick leaves, as the property sees it: the monitor has run.
  struct AfterMonitor {
    Configuration configuration;
    SymbolicState moment;
  };
  /// `outcome` is null for the start.
  AfterMonitor leave(const Outcome* outcome, Configuration left,
                     const SymbolicState& readings) const;
  void addBad(const std::optional<Place>& from, const std::vector<z3::expr>& row,
              const z3::expr& condition, const std::optional<Configuration>& before,
              AfterMonitor& left, const SymbolicState& readings, Unknowns& unknowns);
  /// What is known after any tick that leaves this state current.
  [[nodiscard]] z3::expr known(const Configuration& now) const;
  /// The same of the depth, as time has passed.
  [[nodiscard]] z3::expr knownDepth(const Configuration& now) const;
  [[nodiscard]] std::optional<double> climbIn(StateId state, double depth) const;
  /// Whether the climb in force has certainly led to `depth` (m) or above at the time `by`.
  [[nodiscard]] z3::expr hasClimbed(const Configuration& now, double depth,
                                    const z3::expr& by) const;
  /// Time does not pass the change of a condition of clocks, or the end of a climb to a depth that
  /// the property waits for, by more than the gap between two ticks.
  z3::expr noticed(const Configuration& before, const Configuration& after, Unknowns& unknowns);
  std::vector<ExprId> clockConditions(const Control& control) const;
  std::vector<ExprId> clockGuards(const Control& control) const;
  bool readsNoSensor(ExprId root) const;
  void add(Rule rule, Unknowns& unknowns);
  void reach(const Control& control);
  /// A moment with a reading of every sensor; the depth reading is that of the vehicle within its
  /// tolerance.
  SymbolicState readingsOf(const Configuration& configuration, Unknowns& unknowns) const;

  z3::context& context_;
  const ProofContext& proof_context_;
  const Mission& m_;
  const ConeOfInfluence& relevance_;
  const SafetyProperty& watch_;
  Layout layout_;
  std::vector<Rule> rules_;
  std::set<Control> reached_;
  std::vector<Control> pending_;
  uint32_t next_prefix_ = 0;
};

}  // namespace glider::ir::prove
