// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/workers/deal.h"

#include <algorithm>

namespace glider::campaign {

Deal::Deal(const CampaignPlan& plan, const CampaignResult& known, size_t workers)
    : jobs_(plan.jobs), dealt_(workers) {
  const FlightRange range = rangeOf(plan);
  for (uint64_t number = range.begin; number < range.end; ++number) {
    if (!known.verdicts[number]) {
      missing_.push_back(number);
    }
  }
}

std::vector<uint64_t> Deal::next(size_t worker) {
  // Beside the flight under way, each thread has at least one to go on with while a message is on
  // its way, and at most a few, so that all workers end at about the same time.
  constexpr size_t kFewest = 1, kMost = 16, kShare = 4;
  const size_t left = missing_.size() - at_;
  const size_t threads = dealt_.size() * jobs_;
  const size_t ahead = std::clamp(left / (kShare * threads), kFewest, kMost);
  if (dealt_[worker] > jobs_ * (1 + ahead / 2)) {
    return {};
  }
  const size_t count = std::min(left, jobs_ * (1 + ahead) - dealt_[worker]);
  const auto begin = missing_.begin() + static_cast<std::ptrdiff_t>(at_);
  at_ += count;
  dealt_[worker] += count;
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

bool Deal::isDone() const {
  return at_ == missing_.size() && std::ranges::all_of(dealt_, [](size_t n) { return n == 0; });
}

}  // namespace glider::campaign
