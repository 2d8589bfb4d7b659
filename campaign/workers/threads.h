// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_plan.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace glider::campaign {

/// A flight that is over.
struct EndedFlight {
  uint64_t number = 0;
  support::Result<simulator::Verdict> verdict;
  bool hung = false;  ///< it was given up; its verdict is a violation
};

/// Flies flights on the threads of this process, `jobs` of the plan at a time. All functions are
/// for one thread.
class Threads {
 public:
  /// Flights under way are abandoned when `stop` returns true; nothing is then reported of them.
  Threads(const CampaignPlan& plan, std::function<bool()> stop);
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;
  ~Threads();

  /// Flies these as well, after all that were added before.
  void add(const std::vector<uint64_t>& numbers);
  /// The flights that are over since the last call, those first that ended first. Waits for one, at
  /// most `limit`. One that takes longer than the plan allows is over, and no
  /// other begins.
  std::vector<EndedFlight> wait(std::chrono::milliseconds limit);
  /// Begins no other flight and waits for those under way, at most `limit`; returns what has ended.
  std::vector<EndedFlight> land(std::chrono::milliseconds limit);
  /// Ends the flights under way; nothing is reported of them.
  void abandon();
  /// After land: a flight under way did not end. The program can then only be ended by force.
  [[nodiscard]] bool isRunning() const { return running_; }

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;  ///< outlives this if a thread does not end
  std::vector<std::thread> threads_;
  bool running_ = false;
};

}  // namespace glider::campaign
