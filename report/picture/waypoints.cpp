// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/waypoints.h"

#include "report/picture/flight_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::report::picture {
namespace {

using support::Trace;

/// A place known in degrees and in metres, and the metres of a degree there: the series of the
/// WGS 84 ellipsoid (Snyder 1987, eq. 3-18 and on).
struct Anchor {
  double lat, lon, x, y;
  [[nodiscard]] Dot place(double lat_deg, double lon_deg) const {
    const double p = lat * std::numbers::pi / 180;
    const double per_lat = 111132.954 - 559.822 * std::cos(2 * p) + 1.175 * std::cos(4 * p);
    const double per_lon =
        111412.84 * std::cos(p) - 93.5 * std::cos(3 * p) + 0.118 * std::cos(5 * p);
    return {x + (lon_deg - lon) * per_lon, y + (lat_deg - lat) * per_lat};
  }
};

struct Bounds {
  Extent east, north;
  [[nodiscard]] bool isNear(const Dot& dot) const {
    const double reach = std::fmax(east.greatest - east.least, north.greatest - north.least);
    return dot.x > east.least - reach && dot.x < east.greatest + reach &&
           dot.y > north.least - reach && dot.y < north.greatest + reach;
  }
};

}  // namespace

std::vector<Dot> waypointsOf(const Trace& trace) {
  constexpr size_t kMost = 40;
  constexpr double kSame = 1;  // m
  const bool logged = trace.log.has_value();
  const auto lat = valuesOf(trace, logged ? "m_lat" : "true_lat");
  const auto lon = valuesOf(trace, logged ? "m_lon" : "true_lon");
  const auto x = valuesOf(trace, logged ? "dr_x" : "true_x");
  const auto y = valuesOf(trace, logged ? "dr_y" : "true_y");
  const auto to_lat = valuesOf(trace, "c_wpt_lat"), to_lon = valuesOf(trace, "c_wpt_lon");
  size_t known = 0;
  while (logged && known < lat.size() && !std::isfinite(lat[known] + x[known])) {
    ++known;
  }
  if (known >= lat.size() || !std::isfinite(lat[known] + lon[known] + x[known] + y[known])) {
    return {};
  }
  const Anchor anchor{lat[known], lon[known], x[known], y[known]};
  const Bounds flown{extentOf(x), extentOf(y)};
  std::vector<Dot> found;
  for (size_t row = 0; row < to_lat.size() && found.size() <= kMost; ++row) {
    const Dot here = anchor.place(to_lat[row], to_lon[row]);
    const auto same = [&](const Dot& dot) {
      return std::hypot(dot.x - here.x, dot.y - here.y) < kSame;
    };
    if (flown.isNear(here) && std::ranges::none_of(found, same)) {
      found.push_back(here);
    }
  }
  return found.size() > kMost ? std::vector<Dot>() : found;
}

}  // namespace glider::report::picture
