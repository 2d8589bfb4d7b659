// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/command.h"

namespace glider::hooks {

/// How far the vehicle may have sunk while its depth did not show it. A depth that has stopped,
/// flickers about one value or comes only now and then is found by this, however it is wrong: one
/// that lives moves with the vehicle.
class UnseenSink {
 public:
  /// Takes in one cycle, `step_s` after the one before, at whose begin the vehicle had been
  /// commanded `last` (pump NaN: by another behaviour). `depth_m`: NaN while it is not believed.
  void observe(double depth_m, double step_s, const VerticalCommand& last);
  /// Another sensor that lives says that the vehicle is where its depth says.
  void clear() { metres_ = 0; }
  /// At most so far, m.
  [[nodiscard]] double metres() const { return metres_; }

 private:
  void seek(double depth_m);

  double metres_ = 0;
  double seen_m_ = __builtin_nan("");     ///< the depth when it last showed that it moves
  double highest_m_ = __builtin_nan("");  ///< of the depths since then
  double out_s_ = 0;                      ///< for so long the pump has been commanded out
  double in_s_ = 0;                       ///< for so long the vehicle may have been driven down
};

}  // namespace glider::hooks
