// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/watches.h"

#include "hooks/protocol/values.h"

namespace glider::hooks {

bool ProgressWatch::hasGoneOn(uint32_t session, double mission_time_s, double now_s) {
  if (session != session_) {
    session_ = session;
    latest_s_ = -1;
  }
  if (!(mission_time_s > latest_s_)) {
    return false;
  }
  latest_s_ = mission_time_s;
  same_.begin(now_s);
  told_ = false;
  return true;
}

bool ProgressWatch::isStuck(double limit_s, double now_s) {
  const bool stuck = same_.lasts(now_s) >= limit_s;
  const bool news = stuck && !told_;
  told_ = told_ || stuck;
  return news;
}

void AnswerWatch::written(double sequence, double now_s) {
  const auto number =
      sequence >= 1 && sequence <= UINT16_MAX ? static_cast<uint16_t>(sequence) : uint16_t{0};
  if (isNewerSequence(instruction_, number)) {
    return;  // a repeated answer; the newer instruction still waits
  }
  if (instruction_ == 0 && number != 0) {
    unanswered_.begin(now_s);
    told_ = false;
  }
  instruction_ = number;
}

void AnswerWatch::answered(uint32_t sequence) {
  if (instruction_ == sequence) {
    instruction_ = 0;
  }
}

bool AnswerWatch::isOverdue(double limit_s, double now_s) {
  const bool overdue = instruction_ != 0 && unanswered_.lasts(now_s) >= limit_s;
  const bool news = overdue && !told_;
  told_ = told_ || overdue;
  return news;
}

}  // namespace glider::hooks
