// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/reporter.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {

void Reporter::serve(const Subscribe& subscribe) {
  subscription_ = subscribe;
  check_ = subscriptionCheck(subscribe);
  for (Row& row : rows_) {
    row = Row{};
  }
  remembered_ = 0;
}

void Reporter::begin() {
  for (uint32_t i = 0; i < subscription_.count; ++i) {
    Row& row = rows_[i];
    readings_.told[i] = ReadingReport::Nothing;
    row.rest = row.rest > 0 ? static_cast<uint8_t>(row.rest - 1) : uint8_t{0};
    row.brought_in = static_cast<uint8_t>(row.brought_in << 1U);
    row.told_in = static_cast<uint8_t>(row.told_in << 1U);
    row.age = row.age < kRefreshTicks ? static_cast<uint8_t>(row.age + 1) : row.age;
  }
}

void Reporter::report(uint32_t index, double value) {
  Row& row = rows_[index];
  if (row.rest > 0) {
    return;
  }
  row.told_in |= 1U;
  const uint64_t bits = toWire(widthOf(index), value);
  if (row.age < kRefreshTicks && isHeld(index, bits)) {
    readings_.told[index] = ReadingReport::Unchanged;
    return;
  }
  readings_.told[index] = ReadingReport::Value;
  readings_.values[index] = value;
  if (row.bits != bits) {
    row.brought_in = 0;
  }
  row.brought_in |= 1U;
  row.bits = bits;
  row.held = false;
  row.age = 0;
}

uint32_t Reporter::widthOf(uint32_t index) const {
  return sensorWidth(*dictionary_, subscription_.sensors[index].id);
}

bool Reporter::isHeld(uint32_t index, uint64_t bits) const {
  const Row& row = rows_[index];
  if (!row.held || row.bits == bits) {
    return row.held;
  }
  const Subscription& wanted = subscription_.sensors[index];
  const uint32_t width = widthOf(index);
  const double change = fromWire(width, bits) - fromWire(width, row.bits);
  // NaN and the infinities are held only if identical: no dead band covers a change from or to
  // them.
  return wanted.dead_band > 0 && magnitude(change) <= wanted.dead_band;
}

void Reporter::sent(uint8_t sequence) {
  for (uint32_t i = kRemembered - 1; i > 0; --i) {
    sequences_[i] = sequences_[i - 1];
  }
  sequences_[0] = sequence;
  remembered_ = remembered_ < kRemembered ? remembered_ + 1 : remembered_;
}

void Reporter::answered(uint8_t sequence) {
  for (uint32_t ago = 0; ago < remembered_; ++ago) {
    if (sequences_[ago] == sequence) {
      confirm(ago);
      return;
    }
  }
}

void Reporter::confirm(uint32_t ticks_ago) {
  for (uint32_t i = 0; i < subscription_.count; ++i) {
    Row& row = rows_[i];
    const uint32_t brought = uint32_t{row.brought_in} >> ticks_ago;
    const uint32_t told = uint32_t{row.told_in} >> ticks_ago;
    row.held = row.held || (brought & 1U) != 0;
    const uint32_t every = subscription_.sensors[i].every;
    if ((told & 1U) != 0 && every > row.rest + ticks_ago) {
      row.rest = static_cast<uint8_t>(every - ticks_ago);
    }
  }
}

}  // namespace glider::hooks
