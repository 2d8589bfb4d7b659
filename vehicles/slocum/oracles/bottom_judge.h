// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>
#include <vector>

namespace glider::slocum::oracles {

/// Checks the true clearance over the bottom, with any fault of the altimeter. A vehicle whose
/// altimeter gets echoes never touches the bottom. One whose altimeter does not may meet a bottom
/// that it does not know, once at each place, and then leaves it. Touches that are too short for it
/// to notice may be a few more.
class BottomJudge {
 public:
  explicit BottomJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// A new hookbeh begins, which knows no place.
  void restart() {
    places_.clear();
    echoes_ = 0;
  }

 private:
  /// Where the vehicle was on the bottom, and how deep the water was.
  struct Place {
    double east_m, north_m, water_m;
    double at_s;
    double lasts_s = 0;
  };
  [[nodiscard]] bool hearsSeldom() const;
  [[nodiscard]] bool hears(double now_s) const;
  [[nodiscard]] bool mustKnow(const CycleView& view) const;
  void countEcho(const CycleView& view);
  [[nodiscard]] std::string judgePlace(const Place& here) const;
  std::string judgeTouch(const CycleView& view, bool was_dark);
  std::string judgeNewContact(const CycleView& view);
  std::string judgeClearance(const CycleView& view, bool active);

  const JudgeSetup& s_;
  std::vector<Place> places_;
  double altitude_m_ = __builtin_nan("");  ///< the newest reading
  int echoes_ = 0;                         ///< that were right
  double echo_s_ = -1e9;                   ///< when the newest of them came
  double silent_s_ = 0;                    ///< under water since the newest of them
  double last_s_ = __builtin_nan("");      ///< the previous cycle
  double touched_s_ = 0;                   ///< when this contact began
  bool touching_ = false;
  bool met_in_dark_ = false;  ///< the contact began while the flight controller was down
  double allowed_m_ = 0;      ///< how far below the least altitude it may be
  double inactive_s_ = 1e9;   ///< how long the SBC was not in control
};

}  // namespace glider::slocum::oracles
