// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/core/after_tick.h"

#include <stdint.h>

namespace glider::runtime {

/// Requests of this program that the vehicle has refused, or that have had no effect, until the
/// mission log has them. What lasts is logged once a minute, with how often it happened: a vehicle
/// that never obeys must not fill the log. No heap.
class Refusals {
 public:
  enum class Kind : uint8_t {
    PlanStart,    ///< the vehicle refuses to start the plan
    PlanEnd,      ///< it refuses to end the plan
    PlanFailed,   ///< it says that the plan has ended with an error
    Override,     ///< it does not let us override its own mission
    OverrideEnd,  ///< it does not end the override
  };

  /// It has happened `times` more.
  void note(Kind kind, uint32_t times = 1) { times_[static_cast<uint32_t>(kind)] += times; }
  /// Logs what is due. This outlives it.
  [[nodiscard]] AfterTick afterTick() { return {report, this}; }

  /// From one record of a kind to the next, ticks; the vehicles that are steered so have one a
  /// second.
  static constexpr uint32_t kBetween = 60;

 private:
  static void report(void* self, Persistence& persistence);

  static constexpr uint32_t kKinds = 5;
  uint32_t times_[kKinds] = {};  ///< not logged yet
  uint32_t wait_[kKinds] = {};   ///< ticks until more may be logged
};

}  // namespace glider::runtime
