// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/export/export.h"
#include "report/export/shapes.h"
#include "report/figures.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace glider::report {
namespace {

using nlohmann::ordered_json;

/// Seven decimals are a centimetre.
double rounded(double degrees) {
  constexpr double kPerDegree = 1e7;
  return std::round(degrees * kPerDegree) / kPerDegree;
}

ordered_json positionOf(const MapPoint& point) {
  return {rounded(point.longitude_deg), rounded(point.latitude_deg)};
}

ordered_json positionsOf(const std::vector<MapPoint>& points) {
  ordered_json out = ordered_json::array();
  for (const MapPoint& point : points) {
    out.push_back(positionOf(point));
  }
  return out;
}

ordered_json timesOf(const std::vector<MapPoint>& points, double start_utc_s) {
  ordered_json out = ordered_json::array();
  for (const MapPoint& point : points) {
    out.push_back(start_utc_s + point.time_s);
  }
  return out;
}

ordered_json feature(ordered_json properties, const char* type, ordered_json coordinates) {
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}};
}

ordered_json featureOf(const MapLine& line, double start_utc_s) {
  ordered_json coordinates = ordered_json::array(), times = ordered_json::array();
  for (const auto& part : line.parts) {
    coordinates.push_back(positionsOf(part));
    times.push_back(timesOf(part, start_utc_s));
  }
  const bool one = line.parts.size() == 1;
  return feature({{"name", line.name}, {"kind", "track"}, {"times", one ? times[0] : times}},
                 one ? "LineString" : "MultiLineString", one ? coordinates[0] : coordinates);
}

ordered_json featureOf(const MapMark& mark, double start_utc_s) {
  ordered_json properties = {{"name", mark.name}, {"kind", mark.kind}};
  if (std::isfinite(mark.at.time_s)) {
    properties["time"] = start_utc_s + mark.at.time_s;
  }
  return feature(std::move(properties), "Point", positionOf(mark.at));
}

}  // namespace

std::string flightToGeojson(const support::Trace& trace) {
  const MapShapes shapes = shapesOf(trace);
  ordered_json features = ordered_json::array();
  for (const MapLine& line : shapes.lines) {
    features.push_back(featureOf(line, trace.start_utc_s));
  }
  for (const MapMark& mark : shapes.marks) {
    features.push_back(featureOf(mark, trace.start_utc_s));
  }
  for (const MapRing& ring : shapes.rings) {
    features.push_back(feature({{"name", ring.name}, {"kind", "watch circle"}}, "Polygon",
                               ordered_json::array({positionsOf(ring.points)})));
  }
  const ordered_json document = {{"type", "FeatureCollection"},
                                 {"name", flightTitle(trace)},
                                 {"features", std::move(features)}};
  return document.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace glider::report
