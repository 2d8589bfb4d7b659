// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/restarts/restart_flight.h"

#include "flights/flight_setup.h"
#include "flights/sbc_choice.h"
#include "simulator/simulator.h"
#include "support/check.h"
#include "tests/world/fleet.h"

#include <algorithm>
#include <cstdlib>

namespace glider::tests {

size_t RestartFlight::count(support::EventId id) const {
  return static_cast<size_t>(std::ranges::count(trace.events, id, &support::TraceEvent::id));
}

size_t RestartFlight::count(const std::string& what) const {
  return static_cast<size_t>(std::ranges::count_if(trace.events, [&](const auto& event) {
    return textOf(event).find(what) != std::string::npos;
  }));
}

size_t RestartFlight::visits(const std::string& state) const {
  return static_cast<size_t>(std::ranges::count_if(trace.events, [&](const auto& event) {
    return event.id == support::EventId::Transition &&
           std::get<std::string>(event.values[1]) == state &&
           std::get<std::string>(event.values[2]) != "return";
  }));
}

double RestartFlight::deepestIn(const std::string& state) const {
  const int column = trace.column("state");
  const int depth = trace.column("true_depth");
  double deepest = 0;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    const double number = trace.at(row, column);
    if (number == number && trace.state_names.at(static_cast<size_t>(number)) == state) {
      deepest = std::max(deepest, trace.at(row, depth));
    }
  }
  return deepest;
}

double RestartFlight::flown() const {
  const int column = trace.column("state");
  double first = -1;
  double last = -1;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    if (const double number = trace.at(row, column); number == number) {
      last = trace.at(row, 0);
      first = first < 0 ? last : first;
    }
  }
  return last - first;
}

FlyingMission loadText(const std::string& text) {
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  auto mission = loadMission("restarts.mission", text);
  CHECK(mission.has_value(), "the mission of a test");
  return std::move(*mission);
}

RestartFlight flyRestarts(const FlyingMission& mission, const simulator::Faults& faults,
                          double duration_s) {
  static const std::vector<simulator::Scenario> all = scenarios();
  simulator::SimulationSetup setup;
  setup.platform = slocum();
  setup.scenario = *std::ranges::find(all, "default", &simulator::Scenario::name);
  setup.scenario.faults = faults;
  setup.duration_s = duration_s;
  flights::describeMission(setup, *mission.flown);
  flights::RequirementWatch watch(*mission.flown);
  const auto parameters = flights::chooseParameters(mission.flown->mission, {});
  simulator::StartSbc start =
      flights::startInProcess(mission.loaded, *parameters, !faults.empty(), &watch);
  setup.sbc = std::move(*start());
  setup.restart_sbc = std::move(start);
  auto trace = simulator::simulate(std::move(setup));
  CHECK(trace.has_value(), "the flight of a test");
  RestartFlight flight{std::move(*trace), {}};
  flight.violations = watch.violations(flight.trace);
  return flight;
}

}  // namespace glider::tests
