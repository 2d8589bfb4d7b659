// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <z3++.h>

namespace glider::ir::prove {

/// A number of a mission as Z3 sees it: a real, with a truth value that says whether it is known.
/// A double's value is that real, give or take `slack`: the sum of all roundings on the way to it.
struct NumberTerm {
  z3::expr value;
  z3::expr known;
  double slack = 0;
};

/// A truth value: unknown is neither true nor false.
struct TruthTerm {
  z3::expr is_true;
  z3::expr is_false;
};

/// The very value of a finite double.
z3::expr realOf(z3::context& context, double value);
/// What a model gives a real, as the double nearest to it.
double doubleOf(const z3::model& model, const z3::expr& value);
/// Whether a model makes a truth value true.
bool holds(const z3::model& model, const z3::expr& truth);

}  // namespace glider::ir::prove
