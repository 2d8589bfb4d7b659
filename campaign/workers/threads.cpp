// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/workers/threads.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace glider::campaign {

using simulator::Verdict;
using Clock = std::chrono::steady_clock;

namespace {

Verdict hungVerdict() {
  Verdict verdict;
  verdict.outcome = Verdict::Outcome::Violation;
  verdict.violation = "the flight hangs";
  return verdict;
}

/// The flight of one thread.
struct Flying {
  uint64_t number = 0;
  Clock::time_point begun;
  bool hung = false;
};

}  // namespace

struct Threads::Shared {
  Shared(const CampaignPlan& the_plan, std::function<bool()> the_stop)
      : plan(the_plan), stop(std::move(the_stop)), flying(the_plan.jobs), running(the_plan.jobs) {}

  void work(unsigned thread);
  bool take(std::unique_lock<std::mutex>& lock, uint64_t& number);
  void lookForHangs();

  const CampaignPlan plan;
  const std::function<bool()> stop;
  std::atomic<bool> abandoned = false;
  std::mutex mutex;
  std::condition_variable more, changed;  ///< of `waiting`; of `ended` and `running`
  std::deque<uint64_t> waiting;
  bool closed = false;
  std::vector<std::optional<Flying>> flying;
  std::vector<EndedFlight> ended;
  unsigned running;
};

/// The next flight; waits for one. False when there will be none.
bool Threads::Shared::take(std::unique_lock<std::mutex>& lock, uint64_t& number) {
  more.wait(lock, [&] { return closed || !waiting.empty(); });
  if (closed) {
    return false;
  }
  number = waiting.front();
  waiting.pop_front();
  return true;
}

void Threads::Shared::work(unsigned thread) {
  const std::function<bool()> ends = [this] { return abandoned || stop(); };
  std::unique_lock lock(mutex);
  for (uint64_t number = 0; take(lock, number);) {
    flying[thread] = {.number = number, .begun = Clock::now()};
    lock.unlock();
    auto verdict = flyOne(plan, flightOf(plan, number), nullptr, ends);
    // The signal may also have reached the program that was to fly.
    const bool cut_short = ends();
    lock.lock();
    if (!cut_short && !flying[thread]->hung) {
      ended.push_back({number, std::move(verdict)});
    }
    flying[thread].reset();
    changed.notify_all();
  }
  --running;
  changed.notify_all();
}

void Threads::Shared::lookForHangs() {
  for (std::optional<Flying>& one : flying) {
    if (!one || one->hung) {
      continue;
    }
    const std::chrono::duration<double> taken = Clock::now() - one->begun;
    const bool on_board = flightOf(plan, one->number).board.has_value();
    if (taken.count() > (on_board ? plan.hang_on_board_s : plan.hang_s)) {
      one->hung = true;
      closed = true;
      ended.push_back({one->number, hungVerdict(), true});
    }
  }
}

Threads::Threads(const CampaignPlan& plan, std::function<bool()> stop)
    : shared_(std::make_shared<Shared>(plan, std::move(stop))) {
  for (unsigned thread = 0; thread < plan.jobs; ++thread) {
    threads_.emplace_back([shared = shared_, thread] { shared->work(thread); });
  }
}

Threads::~Threads() {
  if (!threads_.empty()) {
    abandon();
    (void)land(std::chrono::seconds(10));
  }
}

void Threads::add(const std::vector<uint64_t>& numbers) {
  const std::scoped_lock lock(shared_->mutex);
  shared_->waiting.insert(shared_->waiting.end(), numbers.begin(), numbers.end());
  shared_->more.notify_all();
}

std::vector<EndedFlight> Threads::wait(std::chrono::milliseconds limit) {
  std::unique_lock lock(shared_->mutex);
  shared_->changed.wait_for(lock, limit, [&] { return !shared_->ended.empty(); });
  shared_->lookForHangs();
  return std::exchange(shared_->ended, {});
}

std::vector<EndedFlight> Threads::land(std::chrono::milliseconds limit) {
  std::unique_lock lock(shared_->mutex);
  shared_->closed = true;
  shared_->more.notify_all();
  running_ = !shared_->changed.wait_for(lock, limit, [&] { return shared_->running == 0; });
  auto ended = std::exchange(shared_->ended, {});
  lock.unlock();
  for (std::thread& thread : threads_) {
    running_ ? thread.detach() : thread.join();
  }
  threads_.clear();
  return ended;
}

void Threads::abandon() {
  shared_->abandoned = true;
}

}  // namespace glider::campaign
