// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"
#include "ir/naps/wake.h"

#include <limits>
#include <vector>

namespace glider::ir {

/// What can make the next ticks do anything else than this one did.
struct Foreseen {
  /// Crossed, Known or Lost, as in a Wake.
  struct Cause {
    WakeKind kind = WakeKind::Crossed;
    SensorId sensor;
    double number = 0;  ///< Crossed
    bool operator==(const Cause&) const = default;
  };
  bool awake = false;                                        ///< it is not known
  double seconds = std::numeric_limits<double>::infinity();  ///< time alone, from then on
  std::vector<Cause> causes;
};

/// The reference for generated code: evaluates the tree of the current state after the tick with
/// the result `tick`.
Foreseen foresee(const Interpreter& interpreter, const Wake& wake, const TickResult& tick);

}  // namespace glider::ir
