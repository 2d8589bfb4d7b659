// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/launch_choice.h"
#include "hooks/micro_modem/messages.h"
#include "simulator/geography/local_frame.h"
#include "simulator/scenario/scenario.h"
#include "support/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glider::flights {

/// Where a vehicle of a fleet starts, from the start of the scenario: metres towards true east and
/// north.
struct StartOffset {
  double east_m = 0;
  double north_m = 0;
};

/// A vehicle in a fleet file.
struct FleetVehicle {
  std::string name;  ///< as a file name: letters, digits, `_` and `-`
  std::filesystem::path mission;
  std::optional<StartOffset> offset;            ///< empty: `place`, or that of the scenario
  std::optional<simulator::GeoPosition> place;  ///< empty: `offset`, or that of the scenario
  std::optional<double> heading_deg;   ///< clockwise from true north; empty: the scenario's
  std::filesystem::path mi;            ///< the vehicle's own mission; empty: the scenario's
  std::vector<std::string> settings;   ///< of its parameters, "name=value"
  std::vector<std::string> user_code;  ///< of its `extern` names
  uint32_t address = 0;                ///< of its acoustic modem, from 1 on; each has another
};

/// Several vehicles that fly together, as a fleet file says it.
struct Fleet {
  std::filesystem::path file;
  std::string name;      ///< the stem of the file's name
  std::string scenario;  ///< the file of one, or the name of a bundled one
  std::optional<uint64_t> seed;
  std::optional<double> duration_s;
  std::optional<double> separation_m;  ///< what any two must keep; empty: nothing is required
  std::vector<FleetVehicle> vehicles;  ///< one at least
};

/// Where a vehicle starts in the sea of the fleet's scenario, as that was read.
simulator::GeoPosition startOf(const FleetVehicle& vehicle, const simulator::Scenario& scenario);

/// A failure that is about one vehicle, with its name.
support::Failure ofVehicle(const FleetVehicle& vehicle, support::Failure failure);

/// The most vehicles of a fleet.
inline constexpr size_t kMostVehicles = 100;

/// The addresses of the modems of a fleet are 1 to this: that is how many vehicles can talk.
inline constexpr uint32_t kMostAddress = hooks::micro_modem::kMostAddress;

/// How many slots the vehicles of a fleet take turns in: up to the greatest address.
uint32_t slotsOf(const Fleet& fleet);

/// Whether `path` is a fleet file, by its name: it ends in `.toml`.
bool isFleetFile(const std::filesystem::path& path);

/// Reads a fleet file. Names of files in it are relative to its folder. GL9001, GL5001.
support::Result<Fleet> loadFleet(const std::filesystem::path& path);

}  // namespace glider::flights
