// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// What hookprog watches of the SBC and of hookbeh, in science time.
namespace glider::hooks {

/// Since when something lasts. A clock that is set back (by GPS) makes it last since then: an alarm
/// comes late by what had passed, not by what the clock was set back.
class Since {
 public:
  void begin(double now_s) { begun_s_ = now_s; }
  /// To be asked often enough to see the clock turn back.
  double lasts(double now_s) {
    if (!(begun_s_ <= now_s)) {
      begun_s_ = now_s;
    }
    return now_s - begun_s_;
  }

 private:
  double begun_s_ = 0;
};

/// Whether a report of the flight controller is of a later cycle than those before it. One of an
/// earlier cycle comes again; two in their order say that the vehicle counts from the beginning.
class CycleWatch {
 public:
  /// `cycle` counts round at 2^24.
  bool isNext(uint32_t cycle);

 private:
  uint32_t newest_ = 0;
  uint32_t earlier_ = 0;  ///< of the newest report, when `was_earlier_`
  bool known_ = false;
  bool was_earlier_ = false;
};

/// Whether the mission in control goes on.
class ProgressWatch {
 public:
  /// `session`, which is in control, has told its mission time. True if that has gone on; another
  /// link changes nothing about it.
  bool hasGoneOn(uint32_t session, double mission_time_s, double now_s);
  /// It told the same time for so long: true once.
  bool isStuck(double limit_s, double now_s);

 private:
  uint32_t session_ = 0;
  double latest_s_ = -1;  // mission time that it has told
  Since same_;
  bool told_ = false;
};

/// Whether hookbeh answers instructions.
class AnswerWatch {
 public:
  /// The instruction with this number went on.
  void written(double sequence, double now_s);
  /// hookbeh's newest answer is to number `sequence`.
  void answered(uint32_t sequence);
  /// None was answered for so long: true once.
  bool isOverdue(double limit_s, double now_s);
  /// The newest without an answer, 0 for none.
  [[nodiscard]] uint16_t instruction() const { return instruction_; }

 private:
  uint16_t instruction_ = 0;
  Since unanswered_;
  bool told_ = false;
};

}  // namespace glider::hooks
