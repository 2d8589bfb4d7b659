// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/validate/moment.h"
#include "ir/core/ops.h"

#include <unordered_map>

namespace glider::codegen::validate {

/// What the expressions of a mission mean, by ir/README.md (the numbers of its rules are in the
/// comments). Written without the code generator, which it judges.
class MissionExpressions {
 public:
  /// Both outlive this.
  MissionExpressions(Moments& moments, const ir::Mission& mission)
      : moments_(moments), mission_(mission) {}

  /// The value now. Calls of C functions change the moment.
  z3::expr number(Moment& moment, ir::ExprId id) { return valueOf(moment, id).number; }
  z3::expr isTrue(Moment& moment, ir::ExprId id) { return valueOf(moment, id).is_true; }
  z3::expr isFalse(Moment& moment, ir::ExprId id) { return valueOf(moment, id).is_false; }
  /// A truth value as variables store it: 0, 1 or unknown; a number unchanged.
  z3::expr asNumber(Moment& moment, ir::ExprId id);

  /// Kleene's three values: neither is unknown.
  struct Value {
    z3::expr number;
    z3::expr is_true;
    z3::expr is_false;
  };
  Value valueOf(Moment& moment, ir::ExprId id);
  /// C truth values as numbers.
  z3::expr asNumber(const Value& value, bool truth);

  /// Mission time less `then`, settled.
  z3::expr since(const Moment& moment, const z3::expr& then);
  z3::expr age(const Moment& moment, ir::SensorId sensor);

 private:
  using Known = std::unordered_map<uint32_t, Value>;
  Value evaluate(Moment& moment, const ir::Expr& expr, const Known& operands);
  z3::expr numeric(const ir::Expr& expr, const Known& operands);
  z3::expr binary(const ir::Expr& expr, const z3::expr& a, const z3::expr& b);
  z3::expr element(const ir::Table& table, const z3::expr& number);
  z3::expr clock(const Moment& moment, ir::ClockOp op);
  Value called(Moment& moment, const ir::Expr& expr, const Known& operands);
  Value comparison(const ir::Expr& expr, const z3::expr& a, const z3::expr& b);
  static Value logic(const ir::Expr& expr, const Known& operands);
  Value held(const ir::Expr& expr, const z3::expr& stored);
  Value truth(const z3::expr& is_true, const z3::expr& is_false);
  Value ofNumber(const z3::expr& number);

  Numbers& numbers() { return moments_.numbers(); }
  Places& places() { return moments_.places(); }

  Moments& moments_;
  const ir::Mission& mission_;
};

}  // namespace glider::codegen::validate
