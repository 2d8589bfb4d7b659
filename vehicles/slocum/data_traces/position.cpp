// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_traces/position.h"

#include "support/trace/submersions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace glider::slocum {
namespace {

constexpr double kNoPosition = std::numeric_limits<double>::quiet_NaN();
constexpr double kForever = std::numeric_limits<double>::infinity();

/// Places by time, in degrees.
struct Places {
  std::vector<double> times_s, lat, lon;
};

/// The updates of a pair of sensors, where both are known.
Places placesOf(const Merged& merged, const char* lat, const char* lon) {
  const Samples north = samplesOf(merged, lat), east = samplesOf(merged, lon);
  Places places;
  for (size_t i = 0; i < north.times_s.size(); ++i) {
    const double time = north.times_s[i];
    const double lat_deg = degreesOf(north.values[i]), lon_deg = degreesOf(east.at(time));
    if (std::fabs(lat_deg) <= 90 && std::fabs(lon_deg) <= 180) {
      places.times_s.push_back(time);
      places.lat.push_back(lat_deg);
      places.lon.push_back(lon_deg);
    }
  }
  return places;
}

/// The GPS fixes that the vehicle accepted: status 0, if it was logged.
Places fixesOf(const Merged& merged) {
  const Samples status = samplesOf(merged, "m_gps_status");
  const Places all = placesOf(merged, "m_gps_lat", "m_gps_lon");
  Places good;
  for (size_t i = 0; i < all.times_s.size(); ++i) {
    const double here = status.at(all.times_s[i]);
    if (std::isnan(here) || here == 0) {
      good.times_s.push_back(all.times_s[i]);
      good.lat.push_back(all.lat[i]);
      good.lon.push_back(all.lon[i]);
    }
  }
  return good;
}

/// A plane that touches the Earth: metres of a degree by the series of the WGS 84 ellipsoid (Snyder
/// 1987, eq. 3-18 and on).
class Plane {
 public:
  Plane(double lat, double lon) : lat_(lat), lon_(lon) {
    const double p = lat * std::numbers::pi / 180;
    per_lat_ = 111132.954 - 559.822 * std::cos(2 * p) + 1.175 * std::cos(4 * p);
    per_lon_ = 111412.84 * std::cos(p) - 93.5 * std::cos(3 * p) + 0.118 * std::cos(5 * p);
  }
  [[nodiscard]] double east(double lon) const { return std::remainder(lon - lon_, 360) * per_lon_; }
  [[nodiscard]] double north(double lat) const { return (lat - lat_) * per_lat_; }

 private:
  double lat_, lon_, per_lat_, per_lon_;
};

/// Whether a place was a GPS fix: at the surface the vehicle takes its position from them.
bool isFix(const Places& places, size_t i, const Places& fixes, const Plane& plane) {
  constexpr double kSoon = 8, kSame = 5;  // s: two of the vehicle's cycles; m
  const auto after = std::ranges::upper_bound(fixes.times_s, places.times_s[i]);
  if (after == fixes.times_s.begin()) {
    return false;
  }
  const auto fix = static_cast<size_t>(after - fixes.times_s.begin()) - 1;
  return places.times_s[i] - fixes.times_s[fix] < kSoon &&
         std::hypot(plane.east(places.lon[i]) - plane.east(fixes.lon[fix]),
                    plane.north(places.lat[i]) - plane.north(fixes.lat[fix])) < kSame;
}

/// For each place the number of times by then that the track was interrupted: a GPS fix has moved
/// the dead-reckoned position (a step that is faster than the vehicle and larger than the noise of
/// the fixes at the surface), or no position was logged for long. From fix to fix the vehicle was
/// moved itself: by the ship that carries it.
std::vector<double> legsOf(const Places& places, const Places& fixes, const Plane& plane) {
  constexpr double kFaster = 3, kLarger = 50, kLonger = 3600;  // m/s, m, s
  std::vector<double> legs;
  for (size_t i = 0; i < places.times_s.size(); ++i) {
    bool moved = false;
    if (i > 0) {
      const double step = std::hypot(plane.east(places.lon[i]) - plane.east(places.lon[i - 1]),
                                     plane.north(places.lat[i]) - plane.north(places.lat[i - 1]));
      const double took = places.times_s[i] - places.times_s[i - 1];
      moved = took > kLonger ||
              (step > kLarger && step > kFaster * took &&
               !(isFix(places, i - 1, fixes, plane) && isFix(places, i, fixes, plane)));
    }
    legs.push_back(i == 0 ? 0 : legs.back() + (moved ? 1 : 0));
  }
  return legs;
}

/// Adds a place as degrees and metres, both named after `names`: lat, lon, east, north.
void addPlaces(const std::array<const char*, 4>& names, const Places& places,
               const std::vector<double>& times_s, const Plane& plane, Between between,
               std::vector<FlightColumn>& columns) {
  auto lat = resampled({places.times_s, places.lat}, times_s, between);
  auto lon = resampled({places.times_s, places.lon}, times_s, between);
  std::vector<double> east, north;
  for (size_t i = 0; i < times_s.size(); ++i) {
    east.push_back(plane.east(lon[i]));
    north.push_back(plane.north(lat[i]));
  }
  columns.push_back({{names[0], "deg"}, std::move(lat)});
  columns.push_back({{names[1], "deg"}, std::move(lon)});
  columns.push_back({{names[2], "m"}, std::move(east)});
  columns.push_back({{names[3], "m"}, std::move(north)});
}

/// The columns from `first` on are unknown between the end of one leg and the begin of the next.
void cutAtLegs(const Places& places, const std::vector<double>& legs,
               const std::vector<double>& times_s, size_t first,
               std::vector<FlightColumn>& columns) {
  const Samples samples{places.times_s, legs};
  for (size_t i = 0; i < times_s.size(); ++i) {
    const size_t count = samples.countUntil(times_s[i]);
    const bool inside = count > 0 && count < legs.size() && legs[count - 1] != legs[count] &&
                        places.times_s[count - 1] != times_s[i];
    for (size_t column = first; inside && column < columns.size(); ++column) {
      columns[column].values[i] = kNoPosition;
    }
  }
}

/// The declination by which magnetic headings differ from true ones: the last one by then, or else
/// the first one.
double magneticVariation(const Samples& variation, double time_s) {
  const size_t count = variation.countUntil(time_s);
  return variation.values[count > 0 ? count - 1 : 0];
}

/// Whether the vehicle was under water between two times.
bool divedBetween(const Samples& depth, double from_s, double to_s) {
  for (size_t i = depth.countUntil(from_s); i < depth.countUntil(to_s); ++i) {
    if (depth.values[i] > support::kSurfaceDepth) {
      return true;
    }
  }
  return false;
}

/// Estimates of the current, by time, m/s.
struct Estimates {
  std::vector<double> times_s, east, north;
};

/// Turns the estimates towards true north: the vehicle's coordinates are those of its compass,
/// whose bearings are the true ones plus the variation.
Estimates estimatesOf(const Samples& x, const Samples& y, const Samples& variation) {
  Estimates estimates;
  for (size_t i = 0; i < x.times_s.size(); ++i) {
    const double time = x.times_s[i], along_x = x.values[i], along_y = y.at(time);
    const double turn = variation.empty() ? 0 : magneticVariation(variation, time);
    if (std::isfinite(along_x + along_y + turn)) {
      estimates.times_s.push_back(time);
      estimates.east.push_back(along_x * std::cos(turn) - along_y * std::sin(turn));
      estimates.north.push_back(along_y * std::cos(turn) + along_x * std::sin(turn));
    }
  }
  return estimates;
}

}  // namespace

std::vector<std::string> positionSensors() {
  return {"m_lat",
          "m_lon",
          "m_gps_lat",
          "m_gps_lon",
          "m_gps_status",
          "c_wpt_lat",
          "c_wpt_lon",
          "m_water_vx",
          "m_water_vy",
          "m_final_water_vx",
          "m_final_water_vy",
          "m_gps_mag_var"};
}

std::vector<FlightColumn> positions(const Merged& merged, const std::vector<double>& times_s) {
  const Places reckoned = placesOf(merged, "m_lat", "m_lon"), fixes = fixesOf(merged);
  const Places waypoints = placesOf(merged, "c_wpt_lat", "c_wpt_lon");
  std::vector<FlightColumn> columns;
  if (!reckoned.times_s.empty() || !fixes.times_s.empty()) {
    const Places& first = reckoned.times_s.empty() ? fixes : reckoned;
    const Plane plane(first.lat[0], first.lon[0]);
    addPlaces({"m_lat", "m_lon", "dr_x", "dr_y"}, reckoned, times_s, plane, Between::Line, columns);
    const auto legs = legsOf(reckoned, fixes, plane);
    cutAtLegs(reckoned, legs, times_s, 0, columns);
    columns.push_back(
        {{"dr_leg", ""}, resampled({reckoned.times_s, legs}, times_s, Between::Hold, kForever)});
    addPlaces({"m_gps_lat", "m_gps_lon", "gps_x", "gps_y"}, fixes, times_s, plane, Between::Nothing,
              columns);
  }
  columns.push_back(
      {{"c_wpt_lat", "deg"},
       resampled({waypoints.times_s, waypoints.lat}, times_s, Between::Hold, kForever)});
  columns.push_back(
      {{"c_wpt_lon", "deg"},
       resampled({waypoints.times_s, waypoints.lon}, times_s, Between::Hold, kForever)});
  return columns;
}

std::vector<FlightColumn> currents(const Merged& merged, const Samples& depth,
                                   const std::vector<double>& times_s, std::string& note) {
  Samples x = samplesOf(merged, "m_water_vx"), y = samplesOf(merged, "m_water_vy");
  if (x.empty() || y.empty()) {
    x = samplesOf(merged, "m_final_water_vx");
    y = samplesOf(merged, "m_final_water_vy");
  }
  const Samples variation = samplesOf(merged, "m_gps_mag_var");
  const Estimates all = estimatesOf(x, y, variation);
  Samples east, north;
  for (size_t i = 0; i < all.times_s.size(); ++i) {
    const bool last =
        i + 1 == all.times_s.size() || divedBetween(depth, all.times_s[i], all.times_s[i + 1]);
    if (last) {
      east.times_s.push_back(all.times_s[i]);
      east.values.push_back(all.east[i]);
      north.values.push_back(all.north[i]);
    }
  }
  north.times_s = east.times_s;
  if (variation.empty() && !east.empty()) {
    note =
        "the directions of currents are relative to magnetic north because the files do not "
        "contain "
        "`m_gps_mag_var`";
  }
  return {{{"current_x", "m/s"}, resampled(east, times_s, Between::Hold, kForever)},
          {{"current_y", "m/s"}, resampled(north, times_s, Between::Hold, kForever)}};
}

}  // namespace glider::slocum
