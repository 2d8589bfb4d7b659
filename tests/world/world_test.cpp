// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The simulator stays inside the environment model of proofs: compiled missions, of the examples
// and of random texts, fly in it through the real protocol while each flight is checked.
// scripts/soak/world flies more of the same.

#include "tests/world/fleet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

namespace glider::tests {
namespace {

using Clock = std::chrono::steady_clock;

/// Flights number `seed` and on, as many at a time as there are processors.
class Flights {
 public:
  Flights(uint64_t count, uint64_t seed)
      : missions_(missions(std::clamp<uint64_t>(count / 50, 8, 400), seed)),
        scenarios_(scenarios()),
        next_(seed),
        first_(seed),
        end_(seed + count) {}

  void fly() {
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
      threads.emplace_back([this] { work(); });
    }
    std::ranges::for_each(threads, &std::thread::join);
  }

  [[nodiscard]] const std::vector<std::string>& broken() const { return broken_; }
  [[nodiscard]] const Use& use(Rule rule) const { return uses_.at(static_cast<size_t>(rule)); }
  [[nodiscard]] uint64_t inControl() const { return in_control_; }

  [[nodiscard]] std::string table() const {
    std::string text = fmt::format("{:<28} {:>12} {:>12}\n", "rule", "looks", "nearest");
    for (const Rule rule : kAllRules) {
      text +=
          fmt::format("{:<28} {:>12} {:>12.3f}\n", nameOf(rule), use(rule).looks, use(rule).most);
    }
    return text + fmt::format(
                      "{} missions, {} scenarios; {} flights in control, {:.0f} h of it; of "
                      "these {} with damaged lines, {} until a command is refused\n",
                      missions_.size(), scenarios_.size(), in_control_, seconds_ / 3600, damaged_,
                      refused_);
  }

 private:
  void work() {
    for (uint64_t number = next_++; number < end_; number = next_++) {
      const FlyingMission& mission = missions_[number % missions_.size()];
      const auto& scenario = scenarios_[number / missions_.size() % scenarios_.size()];
      const Conditions conditions = drawConditions(mission.flown->mission, scenario, number);
      const auto seen = flyWatched(mission, conditions, slocum());
      const std::lock_guard lock(mutex_);
      note(mission, conditions, *seen, number);
    }
  }

  void note(const FlyingMission& mission, const Conditions& conditions, const Seen& seen,
            uint64_t number) {
    if (seen.broken) {
      broken_.push_back(
          fmt::format("flight {}: {} in {}, {}{}: {} at {} s: {}", number, mission.name,
                      conditions.scenario.name, simulator::nameOf(conditions.kind),
                      conditions.whole ? "" : " (lines damaged)", nameOf(seen.broken->rule),
                      seen.broken->time_s, seen.broken->what));
      fmt::print("{}\n", broken_.back());
    }
    for (size_t i = 0; i < kRules; ++i) {
      uses_[i].looks += seen.uses[i].looks;
      uses_[i].most = std::max(uses_[i].most, seen.uses[i].most);
    }
    const bool controlled = seen.in_control_s > 0;
    in_control_ += controlled;
    damaged_ += controlled && !conditions.whole;
    refused_ += seen.refused;
    seconds_ += seen.in_control_s;
    tellProgress();
  }

  void tellProgress() {
    constexpr uint64_t kEvery = 500;
    if (++over_ % kEvery == 0) {
      const std::chrono::duration<double> took = Clock::now() - begin_;
      fmt::print("{} of {} flights, {} not inside, {:.0f} s\n", over_, end_ - first_,
                 broken_.size(), took.count());
      std::fflush(stdout);
    }
  }

  std::vector<FlyingMission> missions_;
  std::vector<simulator::Scenario> scenarios_;
  std::atomic<uint64_t> next_;
  uint64_t first_, end_;
  std::mutex mutex_;
  std::vector<std::string> broken_;
  std::array<Use, kRules> uses_ = {};
  uint64_t over_ = 0, in_control_ = 0, damaged_ = 0, refused_ = 0;
  double seconds_ = 0;
  Clock::time_point begin_ = Clock::now();
};

TEST(World, TheSimulatorStaysInsideWhatProofsAssume) {
  constexpr uint64_t kFew = 160;
  const uint64_t count = wanted("GLIDER_WORLD_FLIGHTS", kFew);
  Flights flights(count, wanted("GLIDER_WORLD_SEED", 1));
  flights.fly();
  constexpr size_t kMostTold = 20;
  for (size_t i = 0; i < std::min(flights.broken().size(), kMostTold); ++i) {
    ADD_FAILURE() << flights.broken()[i];
  }
  EXPECT_EQ(flights.broken().size(), 0U);
  EXPECT_GT(flights.inControl(), count / 2);
  for (const Rule rule : kAllRules) {
    EXPECT_GT(flights.use(rule).looks, count / 3) << nameOf(rule);
  }
  if (count > kFew) {
    fmt::print("{}", flights.table());
  }
}

}  // namespace
}  // namespace glider::tests
