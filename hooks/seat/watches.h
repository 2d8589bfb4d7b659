// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_SEAT_WATCHES_H
#define GLIDER_HOOKS_SEAT_WATCHES_H

#include "hooks/protocol/language.h"

/// What the seat monitors about the SBC and the vehicle's answers, in the time of the computer that
/// it is on.
GLIDER_HOOKS_BEGIN

/// Measures how long a condition has lasted. If the clock is set back (by GPS), counting starts
/// from that moment: an alarm is late by the time that had passed, not by the amount of the change.
typedef struct HookSince {
  double begun_s GLIDER_IS(0);
} HookSince;

GLIDER_INLINE void hookSinceBegin(HookSince* since, double now_s) {
  since->begun_s = now_s;
}
/// Must be called often enough to notice that the clock is set back.
GLIDER_INLINE double hookSinceLasts(HookSince* since, double now_s) {
  if (!(since->begun_s <= now_s)) {
    since->begun_s = now_s;
  }
  return now_s - since->begun_s;
}

/// Checks whether the mission in control makes progress.
typedef struct HookProgressWatch {
  uint32_t session GLIDER_IS(0);
  double latest_s GLIDER_IS(-1);  ///< mission time that it has reported
  HookSince same;
  bool told GLIDER_IS(false);
} HookProgressWatch;

void hookProgressWatchInit(HookProgressWatch* watch);
/// `session`, which is in control, has reported its mission time. True if that has advanced; a
/// new link does not change this.
bool hookProgressWatchHasGoneOn(HookProgressWatch* watch, uint32_t session, double mission_time_s,
                                double now_s);
/// True once when it has reported the same time for `limit_s`.
bool hookProgressWatchIsStuck(HookProgressWatch* watch, double limit_s, double now_s);

/// No SBC can answer now: this time does not count.
void hookProgressWatchRest(HookProgressWatch* watch, double now_s);

/// Checks whether the vehicle answers instructions. It begins with all bytes zero.
typedef struct HookAnswerWatch {
  uint16_t instruction GLIDER_IS(0);  ///< the newest without an answer, 0 for none
  HookSince unanswered;
  bool told GLIDER_IS(false);
} HookAnswerWatch;

/// The instruction with this number was forwarded.
void hookAnswerWatchWritten(HookAnswerWatch* watch, double sequence, double now_s);
/// The vehicle's newest answer is to number `sequence`.
void hookAnswerWatchAnswered(HookAnswerWatch* watch, uint32_t sequence);
/// True once when no instruction has been answered for `limit_s`.
bool hookAnswerWatchIsOverdue(HookAnswerWatch* watch, double limit_s, double now_s);

GLIDER_HOOKS_END

#endif
