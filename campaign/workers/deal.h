// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_result.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glider::campaign {

/// Deals the flights that are not known to workers (processes with `jobs` threads each), a few at a
/// time, because flights differ in length: each worker has some to fly next, and the fewer are left
/// the fewer it gets.
class Deal {
 public:
  /// `known` must have a place for each flight of the plan.
  Deal(const CampaignPlan& plan, const CampaignResult& known, size_t workers);

  /// The numbers that `worker` is to fly next, in order; empty while it has enough.
  std::vector<uint64_t> next(size_t worker);
  /// A flight that was dealt to `worker` is over.
  void isOver(size_t worker) { --dealt_[worker]; }
  /// True when all flights have been dealt and are over.
  [[nodiscard]] bool isDone() const;

 private:
  std::vector<uint64_t> missing_;
  size_t at_ = 0;  ///< of the next to deal
  unsigned jobs_;
  std::vector<size_t> dealt_;  ///< to each worker, and not over
};

}  // namespace glider::campaign
