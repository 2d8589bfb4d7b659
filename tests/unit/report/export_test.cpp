// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/export/export.h"

#include "support/files.h"
#include "support/netcdf/netcdf_library.h"
#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace glider::report {
namespace {

/// A dive and a climb of 10 min, each position 0.01 degrees north of the last.
support::Trace flown(double longitude = -73.8, double step = 0.01) {
  auto trace = smallTrace({{"time", "s"},
                           {"state", "id"},
                           {"true_depth", "m"},
                           {"true_lat", "deg"},
                           {"true_lon", "deg"},
                           {"sci_water_temp", "degC"}},
                          {});
  for (int i = 0; i < 5; ++i) {
    const double depth = i == 0 || i == 4 ? 0 : 20;
    const std::vector<double> row = {150.0 * i, 0, depth, 39 + 0.01 * i, longitude + step * i, 7.5};
    trace.rows.insert(trace.rows.end(), row.begin(), row.end());
  }
  trace.start_utc_s = 1.25e9;
  trace.state_names = {"yo"};
  trace.facts.places = {{"far <end>", 39.1, -73.8}};
  trace.facts.watch_circles = {{39.1, -73.8, 500}};
  return trace;
}

/// The features of one kind.
std::vector<nlohmann::json> featuresOf(const support::Trace& trace, const std::string& kind) {
  std::vector<nlohmann::json> found;
  const nlohmann::json document = nlohmann::json::parse(flightToGeojson(trace));
  EXPECT_EQ(document.at("type"), "FeatureCollection");
  for (const nlohmann::json& feature : document.at("features")) {
    EXPECT_EQ(feature.at("type"), "Feature");
    if (feature.at("properties").at("kind") == kind) {
      found.push_back(feature);
    }
  }
  return found;
}

TEST(Geojson, ATrackIsALineOfLongitudeAndLatitudeInUtc) {
  const auto tracks = featuresOf(flown(), "track");
  ASSERT_EQ(tracks.size(), 1U) << "the trace has no dead-reckoned one";
  const nlohmann::json& geometry = tracks[0].at("geometry");
  EXPECT_EQ(geometry.at("type"), "LineString");
  EXPECT_EQ(geometry.at("coordinates").size(), 5U);
  EXPECT_EQ(geometry.at("coordinates").at(1), nlohmann::json({-73.79, 39.01})) << "longitude first";
  EXPECT_EQ(tracks[0].at("properties").at("times").at(1), 1250000150);
}

TEST(Geojson, AWaypointWithoutANameIsAMark) {
  auto trace = flown();
  const size_t width = trace.columns.size();
  std::vector<double> rows;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    rows.insert(rows.end(), &trace.rows[row * width], &trace.rows[row * width] + width);
    rows.push_back(row < 3 ? 39.1 : 39.2);  // first to the place that has a name
    rows.push_back(-73.8);
  }
  trace.rows = std::move(rows);
  trace.columns.insert(trace.columns.end(), {{"c_wpt_lat", "deg"}, {"c_wpt_lon", "deg"}});
  const auto marks = featuresOf(trace, "waypoint");
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].at("properties").at("name"), "far <end>");
  EXPECT_EQ(marks[1].at("properties").at("name"), "waypoint 1");
  EXPECT_EQ(marks[1].at("geometry").at("coordinates"), nlohmann::json({-73.8, 39.2}));
}

TEST(Geojson, ALineIsCutAtTheAntimeridian) {
  const auto tracks = featuresOf(flown(179.985, 0.01), "track");
  ASSERT_EQ(tracks.size(), 1U);
  const nlohmann::json& parts = tracks[0].at("geometry").at("coordinates");
  EXPECT_EQ(tracks[0].at("geometry").at("type"), "LineString") << "180.005 is not across it";
  auto across = flown(179.985, 0.01);
  for (size_t row = 2; row < 5; ++row) {
    across.rows[row * across.columns.size() + 4] -= 360;
  }
  const nlohmann::json cut = featuresOf(across, "track").at(0).at("geometry");
  EXPECT_EQ(cut.at("type"), "MultiLineString");
  ASSERT_EQ(cut.at("coordinates").size(), 2U);
  EXPECT_EQ(cut.at("coordinates").at(0).back(), nlohmann::json({180.0, 39.015}));
  EXPECT_EQ(cut.at("coordinates").at(1).front(), nlohmann::json({-180.0, 39.015}));
  EXPECT_EQ(parts.size(), 5U);
}

TEST(Geojson, ARingIsClosedAndCounterclockwise) {
  const auto rings = featuresOf(flown(), "watch circle");
  ASSERT_EQ(rings.size(), 1U);
  const nlohmann::json& ring = rings[0].at("geometry").at("coordinates").at(0);
  ASSERT_GE(ring.size(), 4U);
  EXPECT_EQ(ring.front(), ring.back());
  double area = 0;
  for (size_t i = 0; i + 1 < ring.size(); ++i) {
    area += (ring[i][0].get<double>() + 73.8) * (ring[i + 1][1].get<double>() - 39.1) -
            (ring[i + 1][0].get<double>() + 73.8) * (ring[i][1].get<double>() - 39.1);
  }
  EXPECT_GT(area, 0) << "RFC 7946, 3.1.6";
  EXPECT_NEAR(ring[16][1].get<double>() - 39.1, 500 / 111195.0, 1e-6) << "the radius";
}

TEST(Geojson, MarksTheSurfacingAndTheEnds) {
  ASSERT_EQ(featuresOf(flown(), "surfacing").size(), 1U);
  EXPECT_EQ(featuresOf(flown(), "surfacing")[0].at("properties").at("time"), 1250000600);
  EXPECT_EQ(featuresOf(flown(), "start").size(), 1U);
  EXPECT_EQ(featuresOf(flown(), "end").size(), 1U);
  EXPECT_EQ(featuresOf(flown(), "waypoint").size(), 1U);
}

TEST(Geojson, AFlightWithoutRowsHasNoFeatures) {
  EXPECT_EQ(nlohmann::json::parse(flightToGeojson({})).at("features").size(), 0U);
}

TEST(Kml, NamesAreEscapedAndTimesAreUtc) {
  const std::string kml = flightToKml(flown());
  EXPECT_NE(kml.find("<name>far &lt;end&gt;</name>"), std::string::npos) << kml;
  EXPECT_NE(kml.find("<when>2009-08-11T14:13:20Z</when>"), std::string::npos) << kml;
  EXPECT_NE(kml.find("<coordinates>-73.8000000,39.0000000 -73.7900000,39.0100000"),
            std::string::npos)
      << kml;
}

TEST(FlightNetcdf, IsATrajectoryWithTrueCoordinates) {
  const auto path = std::filesystem::path(testing::TempDir()) / "flight.nc";
  ASSERT_TRUE(writeFlightNetcdf(flown(), path));
  const auto text = support::readFile(path);
  ASSERT_TRUE(text);
  int id = -1, variable = -1;
  ASSERT_EQ(nc_open(path.c_str(), NC_NOWRITE, &id), NC_NOERR);
  const auto attribute = [&](int of, const char* name) {
    size_t size = 0;
    EXPECT_EQ(nc_inq_attlen(id, of, name, &size), NC_NOERR) << name;
    std::string value(size, ' ');
    EXPECT_EQ(nc_get_att_text(id, of, name, value.data()), NC_NOERR) << name;
    return value;
  };
  EXPECT_EQ(attribute(NC_GLOBAL, "Conventions"), "CF-1.8");
  EXPECT_EQ(attribute(NC_GLOBAL, "featureType"), "trajectory");
  std::vector<double> values(5);
  ASSERT_EQ(nc_inq_varid(id, "time", &variable), NC_NOERR);
  ASSERT_EQ(nc_get_var_double(id, variable, values.data()), NC_NOERR);
  EXPECT_EQ(values[1], 1.25e9 + 150);
  ASSERT_EQ(nc_inq_varid(id, "lat", &variable), NC_NOERR);
  ASSERT_EQ(nc_get_var_double(id, variable, values.data()), NC_NOERR);
  EXPECT_EQ(values[1], 39.01);
  EXPECT_EQ(attribute(variable, "units"), "degrees_north");
  ASSERT_EQ(nc_inq_varid(id, "sci_water_temp", &variable), NC_NOERR);
  EXPECT_EQ(attribute(variable, "standard_name"), "sea_water_temperature");
  EXPECT_EQ(attribute(variable, "units"), "degree_Celsius");
  EXPECT_EQ(attribute(variable, "coordinates"), "time lat lon depth");
  ASSERT_EQ(nc_inq_varid(id, "depth", &variable), NC_NOERR);
  EXPECT_EQ(attribute(variable, "positive"), "down");
  ASSERT_EQ(nc_inq_varid(id, "profile_index", &variable), NC_NOERR);
  ASSERT_EQ(nc_get_var_double(id, variable, values.data()), NC_NOERR);
  EXPECT_EQ(values, (std::vector<double>{1, 1, 1, 1, 2}));
  EXPECT_EQ(nc_inq_varid(id, "true_lat", &variable), NC_ENOTVAR) << "it is the coordinate";
  nc_close(id);
}

TEST(FlightNetcdf, AFileThatCannotBeWrittenIsAnError) {
  const auto written = writeFlightNetcdf(flown(), "/nonexistent/flight.nc");
  ASSERT_FALSE(written);
}

}  // namespace
}  // namespace glider::report
