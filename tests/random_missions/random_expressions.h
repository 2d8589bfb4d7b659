// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/scopes.h"
#include "tests/random_missions/random.h"

namespace glider::random_missions {

/// Where an expression stands, and so what it may read.
struct Scope {
  ir::ListKind list = ir::ListKind::Always;
  ir::StateId state;                    ///< of every list but Always
  uint32_t variables_end = UINT32_MAX;  ///< of an initial value: variables before this one
  bool initial = false;                 ///< nothing is watched over time
  uint32_t sets_from = 0;               ///< of what runs every tick: it sets only from this one on
};

/// Adds random expressions to a mission whose sensors, variables and states' number stand.
class ExpressionMaker {
 public:
  ExpressionMaker(ir::Mission& mission, Random& random) : m_(mission), random_(random) {}

  /// Where what is made from now on stands.
  void stand(const Scope& scope) { scope_ = scope; }
  [[nodiscard]] const Scope& scope() const { return scope_; }

  /// An expression of numbers of this type, nested at most `depth` deep.
  ir::ExprId number(ir::Type type, uint32_t depth);
  /// An expression of truth, nested at most `depth` deep (comparisons and what they compare come on
  /// top).
  ir::ExprId guard(uint32_t depth);
  /// Comparisons of sensors and clocks with constants, as long lists of cases have them; at times
  /// combined with something else.
  ir::ExprId thresholds();
  /// Either, kept in the variable's range.
  ir::ExprId valueFor(const ir::Variable& variable, uint32_t depth);
  /// Watches what a C function gives over time, for no expression to read.
  void unread();
  /// What a state may log: a sensor or a clock.
  ir::ExprId logged();
  /// `clock >= seconds`.
  ir::ExprId since(ir::Op clock, double seconds);
  ir::ExprId both(ir::ExprId a, ir::ExprId b) { return add(ir::Op::And, {a, b}); }
  ir::ExprId plain(ir::Type type, double value);
  ir::ExprId truth(bool value) { return add(value ? ir::Op::True : ir::Op::False, {}); }
  ir::ExprId variable(ir::VariableId id);
  ir::ExprId atLeast(ir::ExprId a, ir::ExprId b) { return add(ir::Op::GreaterEqual, {a, b}); }

 private:
  ir::ExprId add(ir::Op op, std::array<ir::ExprId, ir::kMostOperands> operands,
                 ir::SensorId sensor = {});
  ir::ExprId keep(ir::Expr expr);
  [[nodiscard]] bool readable(ir::ExprId id) const;
  ir::ExprId constant(ir::Type type);
  double plainValue(ir::Type type);
  ir::ExprId leaf(ir::Type type);
  std::optional<ir::ExprId> anyVariable(ir::Type type);
  ir::ExprId watched(uint32_t depth);
  std::optional<ir::ExprId> window(ir::Type type);
  ir::ExprId leg(ir::Temporal t);
  ir::ExprId steepest(ir::Temporal t);
  ir::ExprId temporal(ir::Temporal temporal);
  ir::ExprId ofWater();
  std::optional<ir::ExprId> geometry(ir::Type type, uint32_t depth);
  ir::ExprId element(ir::Type type, uint32_t depth);
  std::optional<ir::ExprId> call(ir::Type type, uint32_t depth);
  std::optional<ir::ExprId> idleCall();
  ir::ExprId product(ir::Type type, uint32_t depth);
  ir::ExprId quotient(ir::Type type, uint32_t depth);
  ir::ExprId root(ir::Type type, uint32_t depth);
  ir::ExprId comparison();
  ir::ExprId threshold();

  ir::Mission& m_;
  Random& random_;
  Scope scope_;
  std::vector<ir::Reads> reads_;  ///< of every expression
};

}  // namespace glider::random_missions
