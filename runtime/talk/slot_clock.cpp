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
    reports_ = 0;
  }
  if (utc.updated == reported_) {
    return;
  }
  if (any_) {  // the first may be that of a checkpoint, of before an outage
    take(utc.value);
  }
  any_ = true;
  reported_ = utc.updated;
}

/// A report is late by a cycle of the vehicle and the way to the SBC, now more and now less. So the
/// offset of the one that was least late counts, of the last few.
void SlotClock::take(double utc) {
  constexpr double kSetBackSecs = 30;  // no report is that late
  const double offset = utc - now_;
  if (!(utc >= kEarliest) || !(offset > offset_ - kSetBackSecs)) {
    reports_ = 0;
  }
  at_ = now_;
  if (!(utc >= kEarliest)) {
    return;
  }
  offsets_[reports_ % kReports] = offset;
  ++reports_;
  offset_ = offset;
  for (uint32_t i = 0; i < kReports && i < reports_; ++i) {
    offset_ = offsets_[i] > offset_ ? offsets_[i] : offset_;
  }
}

bool SlotClock::slot(uint64_t* slot, double* passed_s) const {
  constexpr double kMostSlots = 1e15;
  const double since = now_ - at_;
  const double utc = now_ + offset_;
  const double slots = utc / talk_.slot_s;
  if (!(reports_ != 0 && since <= kMostWithoutReport && slots >= 0 && slots < kMostSlots)) {
    return false;
  }
  *slot = static_cast<uint64_t>(slots);
  *passed_s = utc - static_cast<double>(*slot) * talk_.slot_s;
  return true;
}

}  // namespace glider::runtime::talk
