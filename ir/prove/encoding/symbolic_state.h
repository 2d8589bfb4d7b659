// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/ops.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/encoding/terms.h"
#include "ir/prove/encoding/unknowns.h"

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace glider::ir::prove {

/// The values of a mission at one tick, as terms. Readings, clocks, variables and temporals are
/// free within what is known about them, or given by the caller; expressions follow from them.
/// Every value that a trace can have at a tick is a value that these terms can have.
///
/// Values that Z3 does not compute exactly are free within their interval: products and quotients
/// of two unknowns, roots, angles, places. So what has no solution here has none in flight, and a
/// solution must be checked on the interpreter (`ir/eval`).
class SymbolicState {
 public:
  /// Both must outlive this. A copy shares the unknowns; terms that were made before the copy are
  /// the same in both.
  SymbolicState(Unknowns& unknowns, const ProofContext& proof_context)
      : unknowns_(unknowns), proof_context_(proof_context), mission_(proof_context.mission) {}

  /// The value of a number; of a truth value.
  const NumberTerm& number(ExprId id);
  const TruthTerm& truth(ExprId id);

  /// A sensor's reading, made when it is first asked for.
  const NumberTerm& reading(SensorId id);
  /// Time since its newest frame, s.
  const z3::expr& age(SensorId id);
  const z3::expr& missionTime();
  const z3::expr& stateTime();
  const z3::expr& resumeTime();
  const NumberTerm& numberOf(VariableId id);
  const TruthTerm& truthOf(VariableId id);
  const NumberTerm& numberOf(TemporalId id);
  const TruthTerm& truthOf(TemporalId id);
  /// What a use of a C function gives in this tick: anything within the function's range.
  const NumberTerm& numberOf(UseId id);
  const TruthTerm& truthOf(UseId id);

  /// Gives a free term a value. Terms computed before keep the old one.
  void setReading(SensorId id, NumberTerm value) { readings_.insert_or_assign(id.index, value); }
  void setClocks(z3::expr mission_time, z3::expr state_time, z3::expr resume_time);
  void set(VariableId id, const NumberTerm& value) { numbers_.insert_or_assign(id.index, value); }
  void set(VariableId id, const TruthTerm& value) { truths_.insert_or_assign(id.index, value); }
  void set(TemporalId id, const NumberTerm& value) {
    watched_numbers_.insert_or_assign(id.index, value);
  }
  void set(TemporalId id, const TruthTerm& value) {
    watched_truths_.insert_or_assign(id.index, value);
  }
  /// From now on the remainder by a constant is not free, but what it is of the dividend: for a
  /// question whose model is described, `timeofday` then fits the clock. It needs whole numbers,
  /// which a search for invariants does without.
  void relateRemainders() { relates_remainders_ = true; }
  /// From now on `resumetime` is `statetime`: the state is never resumed.
  void isNotResumed() { is_resumed_ = false; }
  /// Forgets the values of expressions, because a variable has changed.
  void forget();
  /// Forgets what the lists of a state watch, because it is entered and all of it starts again.
  void restart(StateId state);

  [[nodiscard]] const Mission& mission() const { return mission_; }
  [[nodiscard]] z3::context& context() { return unknowns_.context(); }
  [[nodiscard]] Unknowns& unknowns() { return unknowns_; }
  [[nodiscard]] const ProofContext& proof_context() const { return proof_context_; }
  /// The sensors and variables that have been asked for.
  [[nodiscard]] const std::map<uint32_t, NumberTerm>& readings() const { return readings_; }
  [[nodiscard]] const std::map<uint32_t, NumberTerm>& numbers() const { return numbers_; }
  [[nodiscard]] const std::map<uint32_t, TruthTerm>& truths() const { return truths_; }
  /// The clocks that have been asked for, by their names in the language.
  [[nodiscard]] std::vector<std::pair<const char*, z3::expr>> clocks() const;

  z3::expr real(double value) { return realOf(context(), value); }

 private:
  z3::expr knownOf(VariableId id);
  /// The state in which a temporal was evaluated whose parts have been computed in this one: before
  /// any list was tried.
  SymbolicState whenJudged(TemporalId id);
  void lower(ExprId root);
  void lowerOne(uint32_t index);
  void lowerNumber(uint32_t index);
  void lowerTruth(uint32_t index);
  NumberTerm arithmetic(const Expr& e, const Interval& interval);
  z3::expr clock(ClockOp op);
  NumberTerm unary(const Expr& e, const Interval& interval);
  NumberTerm binary(const Expr& e, const Interval& interval);
  NumberTerm sum(const Expr& e, const Interval& interval);
  NumberTerm product(const Expr& e, const Interval& interval);
  NumberTerm quotient(const Expr& e, const Interval& interval);
  NumberTerm smallerOrLarger(const Expr& e);
  NumberTerm clamped(const Expr& e, const Interval& interval);
  NumberTerm chosen(const Expr& e);
  NumberTerm remainder(const Expr& e, const Interval& interval);
  /// A value that is free in its interval, and known only where all operands are.
  NumberTerm anything(const Expr& e, const Interval& interval);
  TruthTerm logic(const Expr& e);
  TruthTerm comparison(const Expr& e);
  z3::expr differRounded(const z3::expr& a, const z3::expr& b, uint32_t index);
  /// Bounds `value` by an interval where it is `known`.
  void bound(const NumberTerm& term, const Interval& interval, Fact::From from = Fact::From::Nature,
             uint32_t index = 0);
  const NumberTerm& operand(const Expr& e, size_t i) { return made_.at(e.operands.at(i).index); }
  const TruthTerm& truthOperand(const Expr& e, size_t i) {
    return made_truths_.at(e.operands.at(i).index);
  }

  /// Two terms, and whether their doubles differ where they do.
  struct RoundedPair {
    z3::expr first;
    z3::expr second;
    z3::expr differ;
  };

  Unknowns& unknowns_;
  const ProofContext& proof_context_;
  const Mission& mission_;
  std::map<uint32_t, NumberTerm> readings_;
  std::map<uint32_t, z3::expr> ages_;
  std::optional<z3::expr> mission_time_;
  std::optional<z3::expr> state_time_;
  std::optional<z3::expr> resume_time_;
  std::map<uint32_t, NumberTerm> numbers_;  ///< of variables
  std::map<uint32_t, TruthTerm> truths_;
  std::map<uint32_t, NumberTerm> watched_numbers_;  ///< of temporals
  std::map<uint32_t, TruthTerm> watched_truths_;
  std::map<uint32_t, NumberTerm> called_numbers_;  ///< of uses
  std::map<uint32_t, TruthTerm> called_truths_;
  std::unordered_map<uint32_t, NumberTerm> made_;  ///< of expressions
  std::unordered_map<uint32_t, TruthTerm> made_truths_;
  std::vector<RoundedPair> rounded_pairs_;
  bool relates_remainders_ = false;
  bool is_resumed_ = true;
};

}  // namespace glider::ir::prove
