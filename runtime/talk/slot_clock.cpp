// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/talk/slot_clock.h"

namespace glider::runtime::talk {

void SlotClock::look(const GliderContext* context, double clock_s) {
  const double passed = clock_s - clock_;
  now_ += passed > 0 ? passed : 0;
  clock_ = clock_s;
  if (context == nullptr) {
    return;
  }
  const GliderReading& utc = context->readings[talk_.utc];
  if (utc.value != utc.value) {
    utc_ = utc.value;
  }
  if (utc.updated != reported_) {
    // The first may be that of a checkpoint, of before an outage.
    utc_ = any_ ? utc.value : __builtin_nan("");
    any_ = true;
    reported_ = utc.updated;
    at_ = now_;
  }
}

bool SlotClock::slot(uint64_t* slot, double* passed_s) const {
  constexpr double kMostSlots = 1e15;
  const double since = now_ - at_;
  const double utc = utc_ + since;
  const double slots = utc / talk_.slot_s;
  if (!(since <= kMostWithoutReport && slots >= 0 && slots < kMostSlots)) {
    return false;
  }
  *slot = static_cast<uint64_t>(slots);
  *passed_s = utc - static_cast<double>(*slot) * talk_.slot_s;
  return true;
}

}  // namespace glider::runtime::talk
