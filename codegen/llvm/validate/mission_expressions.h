// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/validate/memory.h"
#include "ir/core/ops.h"

#include <unordered_map>

namespace glider::codegen::validate {

/// What the expressions of a mission mean, by ir/README.md (the numbers of its rules are in the
/// comments). Written without the code generator, which it checks.
class MissionExpressions {
 public:
  /// Both outlive this.
  MissionExpressions(Effects& effects, const ir::Mission& mission)
      : effects_(effects), mission_(mission) {}

  /// The value now. Calls of C functions change the memory.
  z3::expr number(Memory& memory, ir::ExprId id) { return valueOf(memory, id).number; }
  z3::expr isTrue(Memory& memory, ir::ExprId id) { return valueOf(memory, id).is_true; }
  z3::expr isFalse(Memory& memory, ir::ExprId id) { return valueOf(memory, id).is_false; }
  /// A truth value as variables store it: 0, 1 or unknown; a number unchanged.
  z3::expr asNumber(Memory& memory, ir::ExprId id);

  /// Kleene's three values: neither is unknown.
  struct Value {
    z3::expr number;
    z3::expr is_true;
    z3::expr is_false;
  };
  Value valueOf(Memory& memory, ir::ExprId id);
  /// C truth values as numbers.
  z3::expr asNumber(const Value& value, bool truth);

  /// Mission time less `then`, settled.
  z3::expr since(const Memory& memory, const z3::expr& then);
  z3::expr age(const Memory& memory, ir::SensorId sensor);

 private:
  using Known = std::unordered_map<uint32_t, Value>;
  Value evaluate(Memory& memory, const ir::Expr& expr, const Known& operands);
  z3::expr numeric(const ir::Expr& expr, const Known& operands);
  z3::expr unary(const ir::Expr& expr, const z3::expr& x);
  z3::expr clamp(const z3::expr& x, const z3::expr& lowest, const z3::expr& highest);
  z3::expr binary(const ir::Expr& expr, const z3::expr& a, const z3::expr& b);
  z3::expr element(const ir::Table& table, const z3::expr& number);
  z3::expr clock(const Memory& memory, ir::ClockOp op);
  Value called(Memory& memory, const ir::Expr& expr, const Known& operands);
  Value comparison(const ir::Expr& expr, const z3::expr& a, const z3::expr& b);
  static Value logic(const ir::Expr& expr, const Known& operands);
  Value held(const ir::Expr& expr, const z3::expr& stored);
  Value truth(const z3::expr& is_true, const z3::expr& is_false);
  Value ofNumber(const z3::expr& number);

  Numbers& numbers() { return effects_.numbers(); }
  Places& places() { return effects_.places(); }

  Effects& effects_;
  const ir::Mission& mission_;
};

}  // namespace glider::codegen::validate
