// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/sensors_read.h"
#include "ir/prove/encoding/symbolic_state.h"

namespace glider::ir::prove {

/// Lets `moment` break no assumption about a single moment that reads a sensor which has been asked
/// for: what the report says of it then fits what the mission assumes.
inline void keepAssumptions(SymbolicState& moment) {
  for (const Assumption& assumption : moment.mission().assumptions) {
    const Requirement& watch = assumption.watch;
    if (!watch.condition.valid() || watch.monitor.step.valid()) {
      continue;
    }
    bool asked_for = false;
    forEachSensorRead(moment.mission(), watch.condition, [&](SensorId id) {
      asked_for = asked_for || moment.readings().contains(id.index);
    });
    if (asked_for) {
      moment.unknowns().require(!moment.truth(watch.condition).is_false);
    }
  }
}

}  // namespace glider::ir::prove
