// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/reported.h"

#include "hooks/extctl/decimal.h"

namespace glider::runtime::extctl {
namespace {

using hooks::extctl::kMostSensors;

/// The number before the colon of a pair; `size` if there is none. `end`: the colon.
bool readIndex(const char* pair, uint32_t size, uint32_t* index, uint32_t* end) {
  uint32_t number = 0, at = 0;
  for (; at < size && pair[at] >= '0' && pair[at] <= '9'; ++at) {
    number = number < kMostSensors ? number * 10 + static_cast<uint32_t>(pair[at] - '0') : number;
  }
  *index = number;
  *end = at;
  return at > 0 && at < size && pair[at] == ':';
}

}  // namespace

Reported::Reported(uint32_t count) : count_(count) {
  for (double& value : values_) {
    value = __builtin_nan("");
  }
}

bool Reported::take(const char* pairs, uint32_t size) {
  const double clock = values_[count_ - 1];
  uint32_t begin = 0;
  for (uint32_t at = 0; at <= size; ++at) {
    if (at == size || pairs[at] == ',') {
      if (at > begin) {
        takePair(pairs + begin, at - begin);
      }
      begin = at + 1;
    }
  }
  const double now = values_[count_ - 1];
  const bool whole = now == now && now != clock;
  for (uint32_t i = 0; whole && i < count_; ++i) {
    heard_s_[i] = recent_[i] ? now : heard_s_[i];  // a report is of the cycle that it completes
    recent_[i] = false;
  }
  return whole;
}

void Reported::takePair(const char* pair, uint32_t size) {
  uint32_t index = 0, colon = 0;
  double value = 0;
  if (!readIndex(pair, size, &index, &colon) || index >= count_ ||
      !hooks::extctl::readDecimal(pair + colon + 1, size - colon - 1, &value)) {
    ++bad_;
    return;
  }
  values_[index] = value;
  fresh_[index] = recent_[index] = true;
}

bool Reported::takeReport(uint32_t index, double* value) {
  const double age_s = values_[count_ - 1] - heard_s_[index];
  const bool fresh = fresh_[index] && !(age_s > kKeptSecs);
  fresh_[index] = false;
  *value = values_[index];
  return fresh;
}

}  // namespace glider::runtime::extctl
