// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/verify/intervals.h"

#include <string>
#include <string_view>
#include <vector>

namespace glider::ir::prove {

/// The exact value of a finite double as a term of SMT-LIB of sort Real.
std::string realText(double value);

/// Their disjunction.
std::string anyOf(const std::vector<std::string>& parts);

/// A conjunction in SMT-LIB.
class FormulaParts {
 public:
  /// A bound that is not finite says nothing.
  void atMost(std::string_view name, double most);
  void atLeast(std::string_view name, double least);
  /// A variable that is a number lies in `range` where it is known; an empty one: it never is.
  void knownWithin(const Variable& variable, const Interval& range);
  /// A variable that is never unknown.
  void isKnown(const Variable& variable);
  /// The values that a variable may have.
  void holding(const Variable& variable, const PossibleValues& values);
  void add(std::string part);
  [[nodiscard]] std::string all() const;

 private:
  std::vector<std::string> parts_;
};

}  // namespace glider::ir::prove
