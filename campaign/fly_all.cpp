// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/fly_all.h"

#include "flights/shadowed_sbc.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace glider::campaign {

using simulator::FaultKind;
using simulator::Verdict;
using Clock = std::chrono::steady_clock;

namespace {

/// SplitMix64 (Steele et al. 2014, doi 10.1145/2660193.2660195): neighbouring numbers get unrelated
/// seeds.
uint64_t mixed(uint64_t seed, uint64_t number) {
  uint64_t z = seed + (number + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

Verdict hungVerdict() {
  Verdict verdict;
  verdict.outcome = Verdict::Outcome::Violation;
  verdict.violation = "the flight hangs";
  return verdict;
}

/// Checks a flight as FlightJudge does, until the campaign is stopped.
class StoppableJudge final : public simulator::FlightObserver {
 public:
  StoppableJudge(simulator::JudgeSetup setup, const std::function<bool()>& stop)
      : judge_(std::move(setup)), stop_(stop) {}
  void said(std::span<const uint8_t> bytes, double now_s) override { judge_.said(bytes, now_s); }
  bool cycle(const simulator::CycleView& view) override {
    return judge_.cycle(view) && !(stop_ && stop_());
  }
  [[nodiscard]] Verdict verdict() const { return judge_.verdict(); }

 private:
  simulator::FlightJudge judge_;
  const std::function<bool()>& stop_;
};

/// What the threads of a campaign share. It outlives flyAll when a thread does not end.
struct Work {
  Work(const CampaignPlan& the_plan, CampaignResult known, const CampaignListener& the_listener)
      : plan(the_plan),
        listener(the_listener),
        result(std::move(known)),
        begun(the_plan.jobs),
        flying(the_plan.jobs) {}

  /// The next flight that is still to be flown; false when there is none.
  bool takeNext(uint64_t& number) {
    while (next < plan.flights && result.verdicts[next]) {
      ++next;
    }
    number = next++;
    return number < plan.flights && !result.failure && !result.hung && !result.interrupted;
  }
  void finish(const CampaignFlight& flight, support::Result<Verdict> verdict) {
    // The signal may also have reached the program that was to fly, and a flight that has been
    // reported as hanging may still end.
    if (result.interrupted || result.verdicts[flight.number]) {
      return;
    }
    if (!verdict) {
      result.failure = verdict.error();
      return;
    }
    if (auto noted = listener.over(flight, *verdict); !noted) {
      result.failure = noted.error();
    }
    result.verdicts[flight.number] = std::move(*verdict);
    ++over;
  }

  CampaignPlan plan;
  CampaignListener listener;
  std::mutex mutex;
  std::condition_variable changed;
  uint64_t next = 0, over = 0;
  unsigned running = 0;
  CampaignResult result;
  std::vector<Clock::time_point> begun;
  std::vector<std::optional<uint64_t>> flying;  ///< the flight of each thread
};

void workOn(const std::shared_ptr<Work>& work, unsigned thread) {
  std::unique_lock lock(work->mutex);
  for (uint64_t number = 0; work->takeNext(number);) {
    work->begun[thread] = Clock::now();
    work->flying[thread] = number;
    lock.unlock();
    const CampaignFlight flight = flightOf(work->plan, number);
    auto verdict = flyOne(work->plan, flight, nullptr, work->listener.stop);
    const bool stop = work->listener.stop();
    lock.lock();
    work->result.interrupted = work->result.interrupted || stop;
    work->flying[thread].reset();
    work->finish(flight, std::move(verdict));
  }
  --work->running;
  work->changed.notify_all();
}

void lookForHangs(Work& work) {
  for (size_t thread = 0; thread < work.flying.size(); ++thread) {
    if (!work.flying[thread]) {
      continue;
    }
    const std::chrono::duration<double> taken = Clock::now() - work.begun[thread];
    const CampaignFlight flight = flightOf(work.plan, *work.flying[thread]);
    if (taken.count() > (flight.board ? work.plan.hang_on_board_s : work.plan.hang_s)) {
      work.finish(flight, hungVerdict());
      work.result.hung = true;
    }
  }
}

}  // namespace

CampaignFlight flightOf(const CampaignPlan& plan, uint64_t number) {
  const uint64_t turn = number / plan.missions.size();
  CampaignFlight flight;
  flight.number = number;
  flight.mission = number % plan.missions.size();
  const size_t kinds = plan.kinds.size();
  flight.kind = plan.kinds[turn % kinds];
  // A different manner for each kind in each turn of the kinds.
  flight.manner =
      static_cast<simulator::Manner>((turn % kinds + turn / kinds) % simulator::kManners);
  flight.seed = mixed(plan.seed, number);
  // Independent of what the seed draws, so that the same flight in process has the same faults.
  const uint64_t choice = mixed(~plan.seed, number);
  if (!plan.boards.empty() && choice % 100 < plan.board_percent) {
    flight.board = choice / 100 % plan.boards.size();
  }
  return flight;
}

simulator::DrawnFaults faultsOf(const CampaignPlan& plan, const CampaignFlight& flight) {
  return simulator::drawFaults(flight.kind, flight.manner, flight.seed,
                               plan.missions[flight.mission].times);
}

namespace {

/// What starts the SBC of a flight; on a board, `watch` watches the same mission in this process.
simulator::StartSbc startOf(const CampaignMission& mission, const CampaignFlight& flight,
                            flights::RequirementWatch* watch) {
  if (!flight.board) {
    return watch != nullptr ? mission.new_watched_flight(watch) : mission.new_flight();
  }
  simulator::StartSbc flown = mission.on_board[*flight.board]();
  return watch != nullptr
             ? flights::shadowed(std::move(flown), mission.new_watched_flight(watch), *watch)
             : flown;
}

}  // namespace

support::Result<Verdict> flyOne(const CampaignPlan& plan, const CampaignFlight& flight,
                                support::Trace* trace, const std::function<bool()>& stop) {
  const CampaignMission& mission = plan.missions[flight.mission];
  std::optional<flights::RequirementWatch> watch;
  if (mission.new_watched_flight) {
    watch.emplace(*mission.compiled);
  }
  simulator::StartSbc start = startOf(mission, flight, watch ? &*watch : nullptr);
  auto sbc = start();
  if (!sbc) {
    return std::unexpected(sbc.error());
  }
  const simulator::DrawnFaults drawn = faultsOf(plan, flight);
  simulator::SimulationSetup setup;
  setup.platform = mission.platform;
  setup.scenario = plan.scenario;
  setup.scenario.vehicle = mission.vehicle;
  drawn.applyTo(setup.scenario);
  setup.seed = flight.seed;
  setup.sbc = std::move(*sbc);
  setup.restart_sbc = std::move(start);
  // A mission may have to start again after the last fault.
  setup.duration_s = plan.scenario.duration_s + setup.scenario.faults.lastEnd();
  if (drawn.lasts()) {  // it may never reach its exit: abend's overtime ends it
    *setup.duration_s += simulator::overtimeOf(setup.scenario);
  }
  std::vector<FaultKind> kinds = simulator::kindsOf(plan.scenario.faults);
  kinds.insert(kinds.end(), drawn.kinds.begin(), drawn.kinds.end());
  simulator::JudgeSetup judged = simulator::judgeSetup(mission.platform, setup.scenario, kinds);
  judged.mean_W = mission.mean_W;
  StoppableJudge judge(std::move(judged), stop);
  setup.observer = &judge;
  auto flown = simulator::simulate(std::move(setup));
  if (!flown) {
    return std::unexpected(flown.error());
  }
  Verdict verdict = judge.verdict();
  if (watch) {
    for (const flights::FlownViolation& violation : watch->violations(*flown)) {
      verdict.requirements.push_back(violation.number);
    }
  }
  if (trace != nullptr) {
    *trace = std::move(*flown);
  }
  return verdict;
}

support::Result<void> measureMissions(CampaignPlan& plan) {
  CampaignPlan whole = plan;  // the scenario's own faults are not usual either
  whole.scenario.faults = {};
  for (size_t i = 0; i < plan.missions.size(); ++i) {
    CampaignFlight flight;
    flight.mission = i;
    flight.seed = plan.scenario.seed;
    const auto verdict = flyOne(whole, flight);
    if (!verdict) {
      return std::unexpected(verdict.error());
    }
    plan.missions[i].times = {verdict->end_s, verdict->take_s, verdict->release_s,
                              verdict->deepest_m, verdict->hover};
    plan.missions[i].mean_W = verdict->mean_W;
  }
  return {};
}

CampaignResult flyAll(const CampaignPlan& plan, CampaignResult known,
                      const CampaignListener& listener) {
  const auto work = std::make_shared<Work>(plan, std::move(known), listener);
  work->result.verdicts.resize(plan.flights);
  work->running = plan.jobs;
  work->over = static_cast<uint64_t>(std::ranges::count_if(
      work->result.verdicts, [](const auto& verdict) { return verdict.has_value(); }));
  std::vector<std::thread> threads;
  for (unsigned thread = 0; thread < plan.jobs; ++thread) {
    threads.emplace_back(workOn, work, thread);
  }
  constexpr auto kGlance = std::chrono::milliseconds(200);
  std::unique_lock lock(work->mutex);
  while (work->running > 0 && !work->result.hung && !work->result.interrupted) {
    work->changed.wait_for(lock, kGlance);
    lookForHangs(*work);
    work->result.interrupted = work->result.interrupted || listener.stop();
    listener.progress(work->over);
  }
  constexpr auto kToLand = std::chrono::seconds(10);
  const bool over =
      work->changed.wait_for(lock, work->result.hung ? std::chrono::seconds(1) : kToLand,
                             [&] { return work->running == 0; });
  CampaignResult result = work->result;
  result.running = !over;
  lock.unlock();
  for (std::thread& thread : threads) {
    over ? thread.join() : thread.detach();
  }
  return result;
}

}  // namespace glider::campaign
