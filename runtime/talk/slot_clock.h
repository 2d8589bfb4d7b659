// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"
#include "runtime/abi/talk_mission.h"

#include <stdint.h>

namespace glider::runtime::talk {

/// UTC as the vehicle's frames report it, and by the SBC's clock between them.
class SlotClock {
 public:
  /// Longer than this after the vehicle has reported UTC, it is unknown, s.
  static constexpr double kMostWithoutReport = 60;

  explicit SlotClock(const GliderTalk& talk) : talk_(talk) {}

  /// Takes in the SBC's clock, s, and the mission's memory; null: it has none yet. A clock that
  /// goes back counts nothing.
  void look(const GliderContext* context, double clock_s);
  /// The time that the SBC's clock has counted so far, s.
  [[nodiscard]] double now() const { return now_; }
  /// Whether UTC is known; then the slot, counted since 1970, and how much of it has passed, s.
  bool slot(uint64_t* slot, double* passed_s) const;

 private:
  /// A clock that says less, s since 1970, was never set: 2001.
  static constexpr double kEarliest = 1e9;
  static constexpr uint32_t kReports = 8;

  void take(double utc);

  const GliderTalk& talk_;
  double now_ = 0;
  double clock_ = __builtin_nan("");     ///< the SBC's
  double reported_ = __builtin_nan("");  ///< the newest report: mission time, s
  double offsets_[kReports] = {};        ///< UTC less now(), s, of the newest reports
  uint32_t reports_ = 0;                 ///< in a row; 0: UTC is unknown
  double offset_ = 0;                    ///< the greatest of these
  double at_ = 0;                        ///< of the newest report that was known, by now()
  bool any_ = false;                     ///< there was a report
};

}  // namespace glider::runtime::talk
