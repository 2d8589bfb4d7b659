// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/slocum_sensors.h"
#include "simulator/mission_story.h"
#include "simulator/recorder.h"
#include "simulator/science/sbc_link.h"
#include "simulator/science/serial_line.h"
#include "simulator/simulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::simulator {
namespace {

constexpr double kClotheslineBaud = 9600;
constexpr double kSbcBaud = 115200;
constexpr int kStepsPerSecond = 4;
constexpr int64_t kProgressCycles = 25;
static_assert(kStepsPerSecond * Vehicle::kStep == 1, "the vehicle's step divides a second");

/// The code here was built with the numbers of one platform file: the one given must have the same.
support::Result<void> checkPlatform(const platforms::Platform& platform) {
  struct Wanted {
    uint16_t id;
    const char* name;
    uint8_t bytes;
  };
#define GLIDER_WANTED(number, name, bytes, science) Wanted{number, #name, bytes},
  for (const Wanted& wanted : {GLIDER_SENSOR_LIST(GLIDER_WANTED)}) {
#undef GLIDER_WANTED
    const bool same = wanted.id < platform.sensors.size() &&
                      platform.sensors[wanted.id].name == wanted.name &&
                      platform.sensors[wanted.id].bytes == wanted.bytes;
    if (!same) {
      return support::fail(support::DiagnosticId::platformLacksSensor, platform.name, wanted.name);
    }
  }
  return {};
}

/// Gives events while the SBC was in control its mission time, from the rows around them.
void stampMissionTimes(support::Trace& trace) {
  const int time = trace.column("time"), mission_time = trace.column("missiontime");
  size_t row = 0;
  for (support::TraceEvent& event : trace.events) {
    while (row + 1 < trace.rowCount() && trace.at(row + 1, time) <= event.time_s) {
      ++row;
    }
    if (std::isnan(event.mission_time_s) && row < trace.rowCount()) {
      event.mission_time_s = trace.at(row, mission_time) + event.time_s - trace.at(row, time);
    }
  }
}

/// All that flies, for one flight.
class Simulation {
 public:
  explicit Simulation(SimulationSetup setup)
      : setup_(std::move(setup)),
        seed_(setup_.seed.value_or(setup_.scenario.seed)),
        duration_s_(setup_.duration_s.value_or(setup_.scenario.duration_s)),
        frame_(setup_.scenario.latitude_deg, setup_.scenario.longitude_deg),
        ocean_(setup_.scenario.ocean),
        vehicle_(setup_.scenario.vehicle),
        flight_(setup_.platform, setup_.scenario.skeleton, setup_.scenario.sensors, seed_, frame_,
                journal_),
        science_(seed_, setup_.scenario.sensors),
        link_(setup_.sbc.get(), sbc_line_, journal_),
        story_(setup_.platform, setup_.state_names, setup_.explain),
        recorder_(trace_, ocean_, frame_, setup_.scenario) {
    trace_.mission = setup_.mission_name;
    trace_.scenario = setup_.scenario.name;
    trace_.way = setup_.sbc ? setup_.sbc->way() : "none";
    trace_.seed = seed_;
    trace_.state_names = setup_.state_names;
  }

  support::Trace fly() {
    const auto steps_per_cycle =
        static_cast<int64_t>(setup_.platform.envelope.cycle_s / Vehicle::kStep);
    const auto most_steps = static_cast<int64_t>(duration_s_ / Vehicle::kStep);
    for (int64_t step = 0; step <= most_steps; ++step) {
      const double now = static_cast<double>(step) * Vehicle::kStep;
      clothesline_.setNow(now);
      sbc_line_.setNow(now);
      if (setup_.kill_sbc_at_s && now >= *setup_.kill_sbc_at_s) {
        link_.kill(now);
      }
      if (step % steps_per_cycle == 0 && controlCycle(now, step / steps_per_cycle)) {
        break;
      }
      if (step % kStepsPerSecond == 0) {
        scienceCycle(now);
      }
      link_.pump(now);
      vehicle_.feedSbc(link_.alive());
      vehicle_.step(ocean_, now);
    }
    return finish();
  }

 private:
  /// Returns true when the flight is over.
  bool controlCycle(double now, int64_t number) {
    completeRow();
    flight_.noteSbcGone(!link_.alive());
    flight_.cycle(now, ocean_, vehicle_, clothesline_.left());
    recorder_.row(now, flight_, science_, vehicle_);
    cycle_s_ = now;
    if (setup_.progress && number % kProgressCycles == 0) {
      setup_.progress({now, duration_s_, vehicle_.depth(),
                       story_.flying() ? story_.stateName(story_.state()) : ""});
    }
    if (!flight_.end().empty()) {
      journal_.add(now, "log", flight_.end());
    }
    return !flight_.end().empty();
  }

  void scienceCycle(double now) {
    science_.run(now, ocean_, {vehicle_.depth(), vehicle_.x(), vehicle_.y()}, sbc_line_.left(),
                 clothesline_.right());
    if (story_.follow(now, cycle_s_, science_, flight_, journal_)) {
      flight_.noteTransition();
    }
  }

  /// The SBC's answer to a control cycle is known only by the next one.
  void completeRow() {
    if (!trace_.rows.empty() && flight_.hookActive() && story_.flying()) {
      recorder_.mission(story_.missionTime(cycle_s_), story_.state());
    }
  }

  support::Trace finish() {
    completeRow();
    if (flight_.end().empty()) {
      journal_.add(cycle_s_, "log", fmt::format("the simulated time of {} s is over", duration_s_));
    }
    recorder_.field();
    trace_.events = std::move(journal_.events());
    std::ranges::stable_sort(trace_.events, {}, &support::TraceEvent::time_s);
    stampMissionTimes(trace_);
    return std::move(trace_);
  }

  SimulationSetup setup_;
  uint64_t seed_;
  double duration_s_;
  support::Trace trace_;
  Journal journal_;
  LocalFrame frame_;
  Ocean ocean_;
  Vehicle vehicle_;
  SerialLine clothesline_{kClotheslineBaud};
  SerialLine sbc_line_{kSbcBaud};
  FlightController flight_;
  ScienceComputer science_;
  SbcLink link_;
  MissionStory story_;
  Recorder recorder_;
  double cycle_s_ = 0;
};

}  // namespace

support::Result<support::Trace> simulate(SimulationSetup setup) {
  if (auto checked = checkPlatform(setup.platform); !checked) {
    return std::unexpected(checked.error());
  }
  // Too large for a stack: the queues of hooks are arrays.
  return std::make_unique<Simulation>(std::move(setup))->fly();
}

}  // namespace glider::simulator
