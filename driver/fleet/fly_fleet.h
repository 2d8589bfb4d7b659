// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/fleet/ready_vehicle.h"
#include "driver/json_document.h"
#include "driver/output/flight_folder.h"
#include "support/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::driver {

/// A picture of the flight.
struct FleetPicture {
  std::string file;              ///< empty: none
  std::string chart = "depths";  ///< a name of fleetCharts()
};
/// What can be drawn: "depths", "distances", "tracks".
std::vector<std::string> fleetCharts();

/// The options of `sim` for a fleet.
struct FleetOptions {
  std::string file;
  std::string only;                  ///< the name of the one vehicle that flies; empty: all
  std::string output;                ///< empty: a folder named after the file
  FleetPicture picture;              ///< its file is empty: none
  std::optional<uint64_t> seed;      ///< empty: the fleet's, or its scenario's
  std::optional<double> duration_s;  ///< empty: the fleet's, or its scenario's
};

/// The fleet with what the options say instead of its file.
support::Result<flights::Fleet> fleetFor(const FleetOptions& options);

/// Where the report of a fleet's flight goes.
struct FleetOutput {
  std::string target;  ///< the name of `folder`
  FlightFolder folder;
  FleetPicture picture;
};

/// Writes the report of a flight of what was ready, which took `took_s`. Returns the exit code.
/// `document` (null: text) gets what is printed.
int reportFleet(const flights::Fleet& fleet, ReadyFleet& ready, simulator::FleetFlight& flown,
                double took_s, FleetOutput& output, Json* document);

/// Flies a fleet in one ocean and writes its report, with a folder for each vehicle. Returns the
/// exit code. `document` (null: text) gets what is printed.
int flyFleet(const FleetOptions& options, Json* document);

}  // namespace glider::driver
