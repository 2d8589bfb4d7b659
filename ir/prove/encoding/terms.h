// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <z3++.h>

namespace glider::ir::prove {

/// A number of a mission for Z3: a real, with a truth value that says whether it is known. The
/// double's value differs from that real by at most `slack`: the sum of all rounding errors up to
/// here.
struct NumberTerm {
  z3::expr value;
  z3::expr known;
  double slack = 0;
  /// The double is the real rounded once to the nearest (and settled), as of a sum of two exact
  /// numbers; also where slack is 0, which needs no rounding.
  bool rounded_once = false;

  /// Whether the double is a function of the real that never decreases: rounding and settling are.
  [[nodiscard]] bool isMonotone() const { return rounded_once || slack == 0; }
};

/// A truth value: unknown is neither true nor false.
struct TruthTerm {
  z3::expr is_true;
  z3::expr is_false;
};

/// The exact value of a finite double.
z3::expr realOf(z3::context& context, double value);
/// The value of a real in a model, as the nearest double.
double doubleOf(const z3::model& model, const z3::expr& value);
/// Whether a truth value is true in a model.
bool holds(const z3::model& model, const z3::expr& truth);

}  // namespace glider::ir::prove
