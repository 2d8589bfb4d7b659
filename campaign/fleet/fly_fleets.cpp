// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/fleet/fly_fleets.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace glider::campaign {
namespace {

/// The threads of a campaign take the next number until none is left.
class FleetThreads {
 public:
  FleetThreads(const FleetCampaignPlan& plan, const std::function<bool()>& stop)
      : plan_(plan), stop_(stop), running_(plan.jobs) {
    result_.verdicts.resize(plan.flights);
    for (unsigned i = 0; i < plan.jobs; ++i) {
      threads_.emplace_back([this] { work(); });
    }
  }

  /// How many are over after the next short while; empty: all that will be.
  std::optional<uint64_t> wait() {
    constexpr std::chrono::milliseconds kGlance{200};
    std::unique_lock lock(mutex_);
    const bool all = changed_.wait_for(lock, kGlance, [&] { return running_ == 0; });
    return all ? std::nullopt : std::optional(over_);
  }

  FleetCampaignResult result() {
    threads_.clear();
    const bool all = std::ranges::all_of(result_.verdicts,
                                         [](const auto& verdict) { return verdict.has_value(); });
    result_.interrupted = !all && stop_();
    return std::move(result_);
  }

 private:
  void work() {
    std::unique_lock lock(mutex_);
    while (next_ < plan_.flights && !result_.failure && !stop_()) {
      const uint64_t number = next_++;
      lock.unlock();
      auto verdict = flyFleet(plan_, flightOf(plan_, number), nullptr, stop_);
      lock.lock();
      note(number, std::move(verdict));
    }
    --running_;
    changed_.notify_all();
  }

  void note(uint64_t number, support::Result<FleetVerdict> verdict) {
    if (stop_()) {
      return;
    }
    if (!verdict) {
      result_.failure = verdict.error();
      return;
    }
    result_.verdicts[number] = std::move(*verdict);
    ++over_;
  }

  const FleetCampaignPlan& plan_;
  const std::function<bool()>& stop_;
  std::mutex mutex_;
  std::condition_variable changed_;
  FleetCampaignResult result_;
  uint64_t next_ = 0, over_ = 0;
  unsigned running_;
  std::vector<std::jthread> threads_;  // the last: they use all of the above
};

}  // namespace

FleetCampaignResult flyFleets(const FleetCampaignPlan& plan,
                              const FleetCampaignListener& listener) {
  FleetThreads threads(plan, listener.stop);
  while (const auto over = threads.wait()) {
    listener.progress(*over);
  }
  return threads.result();
}

}  // namespace glider::campaign
