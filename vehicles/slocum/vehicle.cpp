// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/vehicle.h"

#include "vehicles/slocum/oracles/flight_judge.h"
#include "vehicles/slocum/oracles/port_judge.h"
#include "vehicles/slocum/port_files/port_plan.h"
#include "vehicles/slocum/rules/port/port_file.h"
#include "vehicles/slocum/rules/port/port_whole.h"
#include "vehicles/slocum/rules/slocum_mission.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::vehicles {
namespace {

/// A vehicle that is steered by its port: null if the flight's is not. What bounds its depth is
/// what the SBC may command, unless the line damages it: then it is its own abend.
/// Whether a line changes or loses bytes, so that a wrong sentence can pass its sum, which is
/// short. A line that is cut, late or repeats itself says nothing wrong.
bool damagesSentences(const simulator::Faults& faults) {
  return std::ranges::any_of(faults.lines, [](const simulator::LineFault& line) {
    return line.loss > 0 || line.flips > 0 || line.bursts > 0 || line.heard_at_baud > 0;
  });
}

std::unique_ptr<simulator::Judge> makePortJudge(const FlightToJudge& flight) {
  const slocum::MissionFile* const own = slocum::oracles::portFileIn(flight.scenario);
  if (own == nullptr || !slocum::rules::isPortFile(*own)) {
    return nullptr;
  }
  const platforms::Platform& platform = flight.platform;
  const slocum::rules::PortFile port = slocum::rules::portFileOf(*own, platform);
  const slocum::rules::VehicleFile file = slocum::rules::portVehicleFile(*own, "", platform);
  const slocum::rules::Ending silence =
      slocum::rules::portWhole(*own, port, platform).endings.front();
  const bool damaged = damagesSentences(flight.scenario.faults);
  slocum::oracles::PortPromise promise;
  const simulator::Faults& faults = flight.scenario.faults;
  if (!faults.sensors.empty() || !faults.clock.empty() || !faults.flight.empty()) {
    return std::make_unique<slocum::oracles::PortJudge>(promise);  // nothing on it notices those
  }
  // A file without overdepth, which `check` refuses: then the hull's depth.
  const double deepest_m =
      std::isfinite(port.deepest_m) ? port.deepest_m : platform.envelope.greatest_depth_m;
  promise.deepest_m = damaged ? deepest_m
                              : file.commands.greatest_depth_m.value_or(deepest_m) +
                                    platform.envelope.inflection_overshoot_m;
  // A file that does not bring it up, which `check` refuses, is to be seen in flights too: it is
  // compared with the usual one.
  const double usual_s = slocum::PortChoice{}.surface_after_s + platform.world.turn_s +
                         deepest_m / platform.world.slowest_climb_m_s;
  const bool stated =
      silence.proved() && silence.parts.front().seconds <= slocum::kMostSurfaceAfter;
  promise.under_s = stated ? silence.seconds() : usual_s;
  promise.cycle_s = platform.envelope.cycle_s;
  promise.may_abort = damaged || !flight.scenario.faults.aborts.empty();
  // Only d_target_altitude of the file keeps it off, which needs an echo before it is too late.
  constexpr double kMostLost = 0.2, kLeastRange = 15;
  const auto& altimeter = flight.scenario.sensors.altimeter;
  promise.sees_bottom = altimeter.dropout <= kMostLost && altimeter.range_m >= kLeastRange;
  return std::make_unique<slocum::oracles::PortJudge>(promise);
}

std::unique_ptr<simulator::Judge> makeJudge(const FlightToJudge& flight) {
  if (auto port = makePortJudge(flight)) {
    return port;
  }
  slocum::oracles::JudgeSetup setup =
      slocum::oracles::judgeSetup(flight.platform, flight.scenario, flight.kinds);
  setup.mean_W = flight.mean_W;
  return std::make_unique<slocum::oracles::FlightJudge>(std::move(setup));
}

}  // namespace

// A constant of the program: initialisers that run before main() find it complete.
constinit const Vehicle families::slocum = {.name = "slocum",
                                            .own_mission_ending = ".mi",
                                            .read_own_mission = slocum::rules::readSlocumMission,
                                            .usual_own_mission = slocum::rules::usualSlocumMission,
                                            .make_judge = makeJudge};

}  // namespace glider::vehicles
