// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/downsample.h"
#include "report/fleet/fleet_report.h"
#include "report/picture/flight_view.h"

namespace glider::report {

void addFlight(const support::Trace& trace, double east_m, double north_m,
               FleetVehicleReport& vehicle) {
  constexpr size_t kMostPlaces = 20000;
  vehicle.figures = flightFigures(trace);
  vehicle.modem = trace.acoustic;
  const support::Trace shown = downsampled(trace, kMostPlaces);
  vehicle.times_s = picture::valuesOf(shown, "time");
  vehicle.depths_m = picture::valuesOf(shown, "true_depth");
  vehicle.east_m = picture::valuesOf(shown, "true_x");
  vehicle.north_m = picture::valuesOf(shown, "true_y");
  for (double& value : vehicle.east_m) {
    value += east_m;
  }
  for (double& value : vehicle.north_m) {
    value += north_m;
  }
}

}  // namespace glider::report
