// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/reported.h"

#include "hooks/extctl/pairs.h"

namespace glider::runtime::extctl {

Reported::Reported(uint32_t count) : count_(count) {
  for (double& value : values_) {
    value = __builtin_nan("");
  }
}

bool Reported::take(const char* pairs, uint32_t size) {
  const double clock = values_[count_ - 1];
  hooks::extctl::PairReader reader(pairs, size);
  for (hooks::extctl::Pair pair; reader.next(&pair);) {
    if (!pair.good || pair.index >= count_) {
      ++bad_;
      continue;
    }
    values_[pair.index] = pair.value;
    fresh_[pair.index] = recent_[pair.index] = true;
  }
  const double now = values_[count_ - 1];
  const bool whole = now == now && now != clock;
  for (uint32_t i = 0; whole && i < count_; ++i) {
    heard_s_[i] = recent_[i] ? now : heard_s_[i];  // a report is of the cycle that it completes
    recent_[i] = false;
  }
  return whole;
}

bool Reported::takeReport(uint32_t index, double* value) {
  const double age_s = values_[count_ - 1] - heard_s_[index];
  const bool fresh = fresh_[index] && !(age_s > kKeptSecs);
  fresh_[index] = false;
  *value = values_[index];
  return fresh;
}

}  // namespace glider::runtime::extctl
