// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/naps/wake.h"

namespace glider::ir {

/// What can change a truth value, while no variable changes. Each function is about an expression
/// that has not, or has, one value now; if that is not so, the answer may be anything.
class WakeOfTruth {
 public:
  /// `mission` outlives this.
  explicit WakeOfTruth(const Mission& mission) : mission_(mission) {}

  /// It is not true (or, with `value` false, not false): what can make it so.
  Wake becomes(ExprId id, bool value);
  /// It is true (or false): what can make it false (true) or unknown.
  Wake leaves(ExprId id, bool value);
  /// What can change it, with any value.
  Wake changes(ExprId id);

 private:
  Wake logic(const Expr& e, bool value, bool leaves);
  Wake comparison(const Expr& e, bool leaves);
  Wake comparison(ExprId left, ExprId right, support::SourceRange range, bool leaves);
  Wake clocks(ExprId left, ExprId right, support::SourceRange range);
  Wake known(const Expr& e, bool value, bool leaves);
  Wake temporal(ExprId id, bool value, bool leaves);
  Wake became(ExprId id, const Temporal& temporal, bool value, bool leaves);
  Wake held(ExprId id, const Temporal& temporal, bool value, bool leaves);
  Wake of(ExprId id, bool value, bool leaves);

  const Mission& mission_;
  /// How many parts a tree may still get: an expression whose parts occur many times would give one
  /// that is too large to be worth a sleep.
  uint32_t left_ = 4096;
};

}  // namespace glider::ir
