// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/names.h"

namespace glider::slocum::oracles {

/// The depth that a reading of the CTD in this cycle shows, m; NaN without one.
double ctdDepth(const CycleView& view);

/// Whether hookbeh may still refuse to believe the vehicle's depth although it is right: it was
/// wrong, it jumped as no vehicle moves, and no CTD has agreed with it since. Then the vehicle
/// stays at the surface (hooks/hookbeh/README.md, HB-21).
class DepthTrust {
 public:
  /// Takes in one cycle, `step_s` after the previous one.
  void cycle(const CycleView& view, double step_s);
  [[nodiscard]] bool isLost() const { return jumped_ && wrong_s_ >= kLostSecs; }

 private:
  static constexpr double kLostSecs = 10;  ///< hookbeh's own: shorter jumps do not count

  bool jumped_ = false;
  double wrong_s_ = 0;                 ///< how long the depth has been wrong, in all
  double agrees_s_ = 0;                ///< how long a CTD has agreed
  double last_m_ = __builtin_nan("");  ///< the newest reading, and its age
  double age_s_ = 0;
};

}  // namespace glider::slocum::oracles
