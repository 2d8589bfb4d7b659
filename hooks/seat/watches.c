// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/watches.h"

#include "hooks/protocol/values.h"

void hookProgressWatchInit(HookProgressWatch* watch) {
  watch->session = 0;
  watch->latest_s = -1;
  hookSinceBegin(&watch->same, 0);
  watch->told = false;
}

bool hookProgressWatchHasGoneOn(HookProgressWatch* watch, uint32_t session, double mission_time_s,
                                double now_s) {
  if (session != watch->session) {
    watch->session = session;
    watch->latest_s = -1;
  }
  if (!(mission_time_s > watch->latest_s)) {
    return false;
  }
  watch->latest_s = mission_time_s;
  hookSinceBegin(&watch->same, now_s);
  watch->told = false;
  return true;
}

bool hookProgressWatchIsStuck(HookProgressWatch* watch, double limit_s, double now_s) {
  const bool stuck = hookSinceLasts(&watch->same, now_s) >= limit_s;
  const bool news = stuck && !watch->told;
  watch->told = watch->told || stuck;
  return news;
}

void hookProgressWatchRest(HookProgressWatch* watch, double now_s) {
  hookSinceBegin(&watch->same, now_s);
}

void hookAnswerWatchWritten(HookAnswerWatch* watch, double sequence, double now_s) {
  const uint16_t number = sequence >= 1 && sequence <= UINT16_MAX ? (uint16_t)sequence : 0;
  if (hookIsNewerSequence(watch->instruction, number)) {
    return;  // a repeated answer; the newer instruction still waits
  }
  if (watch->instruction == 0 && number != 0) {
    hookSinceBegin(&watch->unanswered, now_s);
    watch->told = false;
  }
  watch->instruction = number;
}

void hookAnswerWatchAnswered(HookAnswerWatch* watch, uint32_t sequence) {
  if (watch->instruction == sequence) {
    watch->instruction = 0;
  }
}

bool hookAnswerWatchIsOverdue(HookAnswerWatch* watch, double limit_s, double now_s) {
  const bool overdue =
      watch->instruction != 0 && hookSinceLasts(&watch->unanswered, now_s) >= limit_s;
  const bool news = overdue && !watch->told;
  watch->told = watch->told || overdue;
  return news;
}
