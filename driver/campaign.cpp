// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/campaign.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace glider::driver {

using simulator::FaultKind;
using simulator::Verdict;
using Clock = std::chrono::steady_clock;

namespace {

constexpr double kHangSecs = 60;

/// SplitMix64 (Steele et al. 2014, doi 10.1145/2660193.2660195): neighbours get unlike seeds.
uint64_t mixed(uint64_t seed, uint64_t number) {
  uint64_t z = seed + (number + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// silence_secs of the scenario's hookbeh; 0 without one.
double silenceOf(const simulator::Scenario& scenario) {
  for (const auto& behaviour : scenario.skeleton.behaviours) {
    if (behaviour.name == "hookbeh") {
      return behaviour.value("silence_secs");
    }
  }
  return 0;
}

Verdict hungVerdict() {
  Verdict verdict;
  verdict.outcome = Verdict::Outcome::Violation;
  verdict.violation = "the flight hangs";
  return verdict;
}

/// What the threads of a campaign share. It outlives flyAll when a thread hangs.
struct Work {
  explicit Work(const CampaignPlan& the_plan)
      : plan(the_plan), begun(the_plan.jobs), flying(the_plan.jobs) {}

  CampaignPlan plan;
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
  while (work->next < work->plan.flights && !work->result.failure && !work->result.hung) {
    const uint64_t number = work->next++;
    work->begun[thread] = Clock::now();
    work->flying[thread] = number;
    lock.unlock();
    auto verdict = flyOne(work->plan, flightOf(work->plan, number));
    lock.lock();
    work->flying[thread].reset();
    if (verdict) {
      work->result.verdicts[number] = std::move(*verdict);
    } else {
      work->result.failure = verdict.error();
    }
    ++work->over;
  }
  --work->running;
  work->changed.notify_all();
}

void lookForHangs(Work& work) {
  for (size_t thread = 0; thread < work.flying.size(); ++thread) {
    const std::chrono::duration<double> taken = Clock::now() - work.begun[thread];
    if (work.flying[thread] && taken.count() > kHangSecs) {
      work.result.verdicts[*work.flying[thread]] = hungVerdict();
      work.result.hung = true;
    }
  }
}

}  // namespace

CampaignFlight flightOf(const CampaignPlan& plan, uint64_t number) {
  const uint64_t missions = plan.missions.size();
  CampaignFlight flight;
  flight.number = number;
  flight.mission = number % missions;
  flight.kind = static_cast<FaultKind>(number / missions % simulator::kFaultKinds);
  flight.seed = mixed(plan.seed, number);
  return flight;
}

support::Result<simulator::SimulationSetup> setupOf(const CampaignPlan& plan,
                                                    const CampaignFlight& flight) {
  const CampaignMission& mission = plan.missions[flight.mission];
  simulator::StartSbc start = mission.new_flight();
  auto sbc = start();
  if (!sbc) {
    return std::unexpected(sbc.error());
  }
  simulator::SimulationSetup setup;
  setup.platform = plan.platform;
  setup.scenario = plan.scenario;
  setup.scenario.faults.add(simulator::drawFaults(flight.kind, flight.seed, mission.flight_s));
  setup.seed = flight.seed;
  setup.sbc = std::move(*sbc);
  setup.restart_sbc = std::move(start);
  // A mission may have to begin anew when the last fault is over.
  setup.duration_s = plan.scenario.duration_s + setup.scenario.faults.lastEnd();
  return setup;
}

support::Result<Verdict> flyOne(const CampaignPlan& plan, const CampaignFlight& flight,
                                support::Trace* trace) {
  auto setup = setupOf(plan, flight);
  if (!setup) {
    return std::unexpected(setup.error());
  }
  simulator::FlightJudge judge(setup->scenario.faults, silenceOf(plan.scenario),
                               plan.platform.envelope.cycle_s);
  setup->onlooker = &judge;
  auto flown = simulator::simulate(std::move(*setup));
  if (!flown) {
    return std::unexpected(flown.error());
  }
  if (trace != nullptr) {
    *trace = std::move(*flown);
  }
  return judge.verdict();
}

support::Result<void> measureMissions(CampaignPlan& plan) {
  for (size_t mission = 0; mission < plan.missions.size(); ++mission) {
    const auto verdict = flyOne(plan, {0, mission, FaultKind::None, plan.scenario.seed});
    if (!verdict) {
      return std::unexpected(verdict.error());
    }
    plan.missions[mission].flight_s = verdict->end_s;
  }
  return {};
}

CampaignResult flyAll(const CampaignPlan& plan, const std::function<void(uint64_t)>& progress) {
  const auto work = std::make_shared<Work>(plan);
  work->result.verdicts.resize(plan.flights);
  work->running = plan.jobs;
  std::vector<std::thread> threads;
  for (unsigned thread = 0; thread < plan.jobs; ++thread) {
    threads.emplace_back(workOn, work, thread);
  }
  constexpr auto kGlance = std::chrono::milliseconds(200);
  std::unique_lock lock(work->mutex);
  while (work->running > 0 && !work->result.hung) {
    work->changed.wait_for(lock, kGlance);
    lookForHangs(*work);
    progress(work->over);
  }
  CampaignResult result = work->result;
  lock.unlock();
  for (std::thread& thread : threads) {
    result.hung ? thread.detach() : thread.join();
  }
  return result;
}

}  // namespace glider::driver
