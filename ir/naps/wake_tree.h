// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/naps/wake.h"

#include <utility>

/// How the trees of wake.h are put together.
namespace glider::ir {

inline Wake awake(support::SourceRange range) {
  Wake wake;
  wake.kind = WakeKind::Awake;
  wake.range = range;
  return wake;
}

/// Each of two things.
inline Wake both(Wake a, Wake b) {
  if (a.kind == WakeKind::Nothing || b.kind == WakeKind::Awake) {
    return b;
  }
  if (b.kind == WakeKind::Nothing || a.kind == WakeKind::Awake) {
    return a;
  }
  Wake wake;
  wake.kind = WakeKind::All;
  wake.parts.push_back(std::move(a));
  wake.parts.push_back(std::move(b));
  return wake;
}

/// By whether a truth value is now true, or, with `of_false`, false.
inline Wake branch(ExprId test, bool of_false, Wake yes, Wake no) {
  if (yes.kind == no.kind && (yes.kind == WakeKind::Nothing || yes.kind == WakeKind::Awake)) {
    return yes;
  }
  Wake wake;
  wake.kind = WakeKind::Branch;
  wake.test = test;
  wake.of_false = of_false;
  wake.parts.push_back(std::move(yes));
  wake.parts.push_back(std::move(no));
  return wake;
}

inline Wake ofSensor(WakeKind kind, SensorId sensor, ExprId right = {}) {
  Wake wake;
  wake.kind = kind;
  wake.sensor = sensor;
  wake.right = right;
  return wake;
}

/// `left`, which rises by 1 a second against `right`, meets it.
inline Wake until(ExprId left, ExprId right) {
  Wake wake;
  wake.kind = WakeKind::Until;
  wake.left = left;
  wake.right = right;
  return wake;
}

/// `right`: a valid expression, or none for a truth value that stays true.
inline Wake keeps(VariableId variable, ExprId right = {}) {
  Wake wake;
  wake.kind = WakeKind::Keeps;
  wake.variable = variable;
  wake.right = right;
  return wake;
}

inline Wake repeats(ListKind list, uint32_t number) {
  Wake wake;
  wake.kind = WakeKind::Repeats;
  wake.list = list;
  wake.number = number;
  return wake;
}

}  // namespace glider::ir
