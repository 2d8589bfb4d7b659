// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/fleet/fleet_json.h"

#include "report/figures.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::driver {
namespace {

/// Null for one that did not use its modem.
Json modemJson(const report::FleetVehicleReport& vehicle) {
  if (!vehicle.modem) {
    return nullptr;
  }
  const support::AcousticTotals& modem = *vehicle.modem;
  return {{"sent", modem.sent},        {"received", modem.received},
          {"lost", modem.lost},        {"on_air_s", modem.on_air_s},
          {"sent_J", modem.sent_J},    {"received_J", modem.received_J},
          {"listen_J", modem.listen_J}};
}

Json vehicleJson(const report::FleetVehicleReport& vehicle) {
  return {{"name", vehicle.name},
          {"mission", vehicle.mission_file},
          {"platform", vehicle.platform},
          {"page", vehicle.page},
          {"problems", vehicle.problems},
          {"modem", modemJson(vehicle)},
          {"figures", Json::parse(report::figuresToJson(vehicle.figures))}};
}

Json pairJson(const report::FleetReport& fleet, const report::FleetPairReport& pair) {
  const bool met = std::isfinite(pair.least_m);
  Json document = {{"vehicles", {fleet.vehicles[pair.one].name, fleet.vehicles[pair.other].name}},
                   {"least_m", numberOrNull(pair.least_m)}};
  if (met) {
    document["at_s"] = pair.least_at_s;
    document["depths_m"] = pair.least_depths_m;
  }
  return document;
}

}  // namespace

Json fleetJson(const report::FleetReport& fleet) {
  Json document = {{"fleet", fleet.name}, {"scenario", fleet.scenario}, {"seed", fleet.seed}};
  document["separation_m"] = fleet.separation_m ? Json(*fleet.separation_m) : Json(nullptr);
  document["vehicles"] = Json::array();
  for (const report::FleetVehicleReport& vehicle : fleet.vehicles) {
    document["vehicles"].push_back(vehicleJson(vehicle));
  }
  document["pairs"] = Json::array();
  for (const report::FleetPairReport& pair : fleet.pairs) {
    document["pairs"].push_back(pairJson(fleet, pair));
  }
  return document;
}

std::string distancesCsv(const report::FleetReport& fleet) {
  std::string out = "time (s)";
  for (const report::FleetPairReport& pair : fleet.pairs) {
    out +=
        fmt::format(",{}-{} (m)", fleet.vehicles[pair.one].name, fleet.vehicles[pair.other].name);
  }
  out += "\n";
  for (size_t row = 0; row < fleet.times_s.size(); ++row) {
    out += fmt::format("{}", fleet.times_s[row]);
    for (const report::FleetPairReport& pair : fleet.pairs) {
      const double apart_m = pair.series_m[row];
      out += std::isfinite(apart_m) ? fmt::format(",{:.2f}", apart_m) : ",";
    }
    out += "\n";
  }
  return out;
}

}  // namespace glider::driver
