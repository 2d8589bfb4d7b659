// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"
#include "runtime/abi/runtime.h"

#include <vector>

namespace glider::flights {

/// A tick of a mission in flight, with the readings that the SBC received for it.
struct HeardTick {
  double mission_time = 0;  ///< s
  double vehicle_time = 0;  ///< s
  std::vector<ir::SensorUpdate> frame;
};

/// The readings that the runtime received for its latest tick; `mission` is what was compiled.
std::vector<ir::SensorUpdate> frameOf(const ir::Mission& mission, const GliderContext& context);

/// Records the ticks of a runtime's first mission, so that the interpreter can repeat them.
class HeardTicks {
 public:
  /// `mission` is the mission that was compiled; it must outlive this.
  explicit HeardTicks(const ir::Mission& mission) : m_(mission) {}

  /// To be called after each poll of the runtime, at vehicle time `now_s`.
  void look(const GliderContext& context, double now_s);

  [[nodiscard]] const std::vector<HeardTick>& ticks() const { return ticks_; }

 private:
  const ir::Mission& m_;
  std::vector<HeardTick> ticks_;
  bool over_ = false;
};

}  // namespace glider::flights
