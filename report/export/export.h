// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "support/trace/trace.h"

#include <filesystem>
#include <string>

namespace glider::report {

/// The tracks, surfacings, waypoints and watched distances of a flight as GeoJSON (RFC 7946):
/// longitude before latitude, rings counterclockwise, lines cut at the antimeridian. `times` of a
/// line are UTC by the vehicle's clock, s since 1970.
std::string flightToGeojson(const support::Trace& trace);

/// The same as KML 2.2.
std::string flightToKml(const support::Trace& trace);

/// The rows of a flight as netCDF-4 by the CF conventions 1.8: one trajectory, whose coordinates
/// are the true time, position and depth, and a variable for each other column. GL9002.
support::Result<void> writeFlightNetcdf(const support::Trace& trace,
                                        const std::filesystem::path& path);

}  // namespace glider::report
