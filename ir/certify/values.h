// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/smt.h"

#include <string>
#include <variant>
#include <vector>

namespace glider::ir::certify {

/// A number (N1): `value` means nothing where `known` is false.
struct Number {
  Term value = "0.0";
  Term known = "false";
  bool operator==(const Number&) const = default;
};

/// A truth value; unknown where both are false. They are never both true.
struct Truths {
  Term is_true = "false";
  Term is_false = "false";
  bool operator==(const Truths&) const = default;
};

using Value = std::variant<Number, Truths>;

/// What `became` or `held` remembers (B1 to B4).
struct Memory {
  Term was = "false";
  Term since = "0.0";
};

/// The vehicle (vehicle.h).
struct Vehicle {
  Term depth = "0.0";
  Term deepest = "0.0";
  Term climbing = "false";
  Term since = "0.0";
  Term top = "0.0";
};

/// All that a tick may change, at one place of it.
struct Store {
  std::vector<Term> entered;  ///< of the waiting states, outermost first, then of the current one
  Term resumed = "0.0";
  std::vector<Value> variables;
  std::vector<Memory> memory;    ///< of all temporals; of windows nothing
  std::vector<Value> temporals;  ///< N14: their values in this tick
  Vehicle vehicle;
};

/// `a` where `condition` is true, otherwise `b`.
Value merged(SmtText& out, const Term& condition, const Value& a, const Value& b);
/// The same of two stores of one state.
Store merged(SmtText& out, const Term& condition, const Store& a, const Store& b);

}  // namespace glider::ir::certify
