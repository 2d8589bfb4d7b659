// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookprog/reporter.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {

void Reporter::serve(const Subscribe& subscribe) {
  subscription_ = subscribe;
  check_ = subscriptionCheck(subscribe);
  for (Row& row : rows_) {
    row = Row{};
  }
}

void Reporter::begin() {
  for (uint32_t i = 0; i < subscription_.count; ++i) {
    Row& row = rows_[i];
    readings_.told[i] = Told::Nothing;
    row.rest = row.rest > 0 ? static_cast<uint8_t>(row.rest - 1) : uint8_t{0};
    row.age = row.age < kRefreshTicks ? static_cast<uint8_t>(row.age + 1) : row.age;
  }
}

void Reporter::report(uint32_t index, double value) {
  Row& row = rows_[index];
  if (row.rest > 0) {
    return;
  }
  const uint64_t bits = toWire(subscription_.sensors[index].id, value);
  if (row.age < kRefreshTicks && isHeld(index, bits)) {
    readings_.told[index] = Told::Unchanged;
    return;
  }
  readings_.told[index] = Told::Value;
  readings_.values[index] = value;
  row.bits = bits;
  row.held = false;
  row.age = 0;
}

bool Reporter::isHeld(uint32_t index, uint64_t bits) const {
  const Row& row = rows_[index];
  if (!row.held || row.bits == bits) {
    return row.held;
  }
  const Subscription& wanted = subscription_.sensors[index];
  const double change = fromWire(wanted.id, bits) - fromWire(wanted.id, row.bits);
  // Of NaN and the infinities only the very same is held.
  return isFinite(change) && wanted.dead_band > 0 && change <= wanted.dead_band &&
         -change <= wanted.dead_band;
}

void Reporter::confirm() {
  for (uint32_t i = 0; i < subscription_.count; ++i) {
    if (readings_.told[i] != Told::Nothing) {
      rows_[i].held = true;
      rows_[i].rest = subscription_.sensors[i].every;
    }
  }
}

}  // namespace glider::hooks
