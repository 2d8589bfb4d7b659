// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// What the seat monitors about the SBC and the vehicle's answers, in the time of the computer that
/// it is on.
namespace glider::hooks {

/// Measures how long a condition has lasted. If the clock is set back (by GPS), counting starts
/// from that moment: an alarm is late by the time that had passed, not by the amount of the change.
class Since {
 public:
  void begin(double now_s) { begun_s_ = now_s; }
  /// Must be called often enough to notice that the clock is set back.
  double lasts(double now_s) {
    if (!(begun_s_ <= now_s)) {
      begun_s_ = now_s;
    }
    return now_s - begun_s_;
  }

 private:
  double begun_s_ = 0;
};

/// Checks whether the mission in control makes progress.
class ProgressWatch {
 public:
  /// `session`, which is in control, has reported its mission time. True if that has advanced; a
  /// new link does not change this.
  bool hasGoneOn(uint32_t session, double mission_time_s, double now_s);
  /// True once when it has reported the same time for `limit_s`.
  bool isStuck(double limit_s, double now_s);

 private:
  uint32_t session_ = 0;
  double latest_s_ = -1;  // mission time that it has reported
  Since same_;
  bool told_ = false;
};

/// Checks whether the vehicle answers instructions.
class AnswerWatch {
 public:
  /// The instruction with this number was forwarded.
  void written(double sequence, double now_s);
  /// The vehicle's newest answer is to number `sequence`.
  void answered(uint32_t sequence);
  /// True once when no instruction has been answered for `limit_s`.
  bool isOverdue(double limit_s, double now_s);
  /// The newest without an answer, 0 for none.
  [[nodiscard]] uint16_t instruction() const { return instruction_; }

 private:
  uint16_t instruction_ = 0;
  Since unanswered_;
  bool told_ = false;
};

}  // namespace glider::hooks
