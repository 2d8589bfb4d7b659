// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/figures.h"
#include "support/trace/trace.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::report {

/// A vehicle of a fleet, and how its flight went.
struct FleetVehicleReport {
  std::string name;
  std::string mission_file;
  std::string platform;
  std::string page;  ///< of its own report, relative to that of the fleet
  FlightFigures figures = {};
  std::optional<support::AcousticTotals> modem = {};  ///< empty: it did not use it
  // For each of some control cycles, its true place; m of the fleet's origin.
  std::vector<double> times_s = {}, depths_m = {}, east_m = {}, north_m = {};
  std::vector<std::string> problems = {};  ///< one line each
};

/// Takes out of a vehicle's trace what the report of its fleet shows; `east_m` and `north_m` are
/// its start. Of a long flight the places are fewer.
void addFlight(const support::Trace& trace, double east_m, double north_m,
               FleetVehicleReport& vehicle);

/// How far two vehicles were apart.
struct FleetPairReport {
  size_t one = 0;  ///< numbers of vehicles
  size_t other = 0;
  double least_m = 0;  ///< infinite: they never flew at the same time
  double least_at_s = 0;
  std::array<double, 2> least_depths_m = {};
  std::vector<double> series_m;  ///< for each of FleetReport::times_s; infinite: not both fly
};

/// The flight of a fleet.
struct FleetReport {
  std::string name;
  std::string scenario;
  uint64_t seed = 0;
  std::optional<double> separation_m;  ///< what every pair must keep; empty: nothing
  std::vector<FleetVehicleReport> vehicles;
  std::vector<FleetPairReport> pairs;
  std::vector<double> times_s;
};

/// The tracks of all vehicles from above as one SVG, with true positions and equal scales.
std::string drawFleetMap(const FleetReport& fleet);
/// Their depths against time, as one SVG.
std::string drawFleetDepths(const FleetReport& fleet);
/// The distances of the kMostDrawnPairs pairs that came nearest, against time, as one SVG; empty if
/// no two vehicles flew at the same time.
std::string drawFleetDistances(const FleetReport& fleet);

inline constexpr size_t kMostDrawnPairs = 6;

/// The colour of a vehicle's lines on all of them.
std::string vehicleColour(const FleetReport& fleet, size_t vehicle);

/// All of it as one self-contained web page without a script. It leads to the pages of the
/// vehicles.
std::string fleetPage(const FleetReport& fleet);

/// The same for a terminal.
std::string fleetSummary(const FleetReport& fleet);

/// "north and east were 134 m apart at 12:40:10, at depths of 12 and 40 m".
std::string nearestText(const FleetReport& fleet, const FleetPairReport& pair);

}  // namespace glider::report
