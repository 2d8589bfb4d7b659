// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Data files as the trace of a flight: units, what is known when, events, currents. The meaning of
// the sensors and codes is that of the vehicle's documentation.

#include "tests/unit/slocum/data_bench.h"
#include "vehicles/slocum/data_traces/events.h"
#include "vehicles/slocum/data_traces/flight_trace.h"
#include "vehicles/slocum/data_traces/position.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>

namespace glider::slocum {
namespace {

using second::Cell;
using second::Draft;
using second::SensorLine;

constexpr double kStart = 1719946527;  // UTC of the first record
constexpr double kUnset = 69696969;

/// One record: seconds after kStart, and the sensors that it updates.
struct Record {
  double time_s;
  std::map<std::string, double> values;
};

/// A data file with these sensors; the clock is added.
Draft draftOf(const std::string& extension, std::vector<SensorLine> sensors,
              const std::vector<Record>& records) {
  Draft draft;
  draft.extension = extension;
  const bool science = extension[0] == 'e' || extension[0] == 't';
  draft.sensors = {{science ? "sci_m_present_time" : "m_present_time", "timestamp", 8, true}};
  draft.sensors.insert(draft.sensors.end(), sensors.begin(), sensors.end());
  draft.rows.emplace_back();
  for (size_t i = 0; i < draft.sensors.size(); ++i) {
    draft.rows[0].push_back({'*', 0});  // the values from before
  }
  for (const Record& record : records) {
    std::vector<Cell> row = {{'*', kStart + record.time_s}};
    for (const SensorLine& sensor : sensors) {
      const auto value = record.values.find(sensor.name);
      row.push_back(value == record.values.end() ? Cell{} : Cell{'*', value->second});
    }
    draft.rows.push_back(row);
  }
  return draft;
}

support::Result<support::Trace> traceOf(const std::vector<Draft>& drafts,
                                        const std::vector<double>& more_times_s = {}) {
  const TestFolder folder;
  for (size_t i = 0; i < drafts.size(); ++i) {
    folder.write("a" + std::to_string(i) + "." + drafts[i].extension, write(drafts[i]));
  }
  SensorLists lists;
  const LogFiles logs = readLogFiles({folder.path()}, lists);
  EXPECT_TRUE(logs.failures.empty());
  return flightTrace(merge(logs.files, flightTraceSensors()), more_times_s);
}

/// The values of a column, rounded to 1e-6; NaN is -999.
std::vector<double> column(const support::Trace& trace, const std::string& name) {
  const int at = trace.column(name);
  std::vector<double> values;
  for (size_t row = 0; at >= 0 && row < trace.rowCount(); ++row) {
    const double value = trace.at(row, at);
    values.push_back(std::isnan(value) ? -999 : std::round(value * 1e6) / 1e6);
  }
  return values;
}

using Values = std::vector<double>;
constexpr double kNone = -999;

std::string unitOf(const support::Trace& trace, const std::string& name) {
  const int at = trace.column(name);
  return at < 0 ? "none" : trace.columns[static_cast<size_t>(at)].unit;
}

std::vector<std::string> eventsOf(const support::Trace& trace, const std::string& kind) {
  std::vector<std::string> out;
  for (const support::TraceEvent& event : trace.events) {
    if (kindOf(event) == kind) {
      out.push_back(std::to_string(std::lround(event.time_s)) + " " + textOf(event) +
                    (event.why.empty() ? "" : "; " + event.why));
    }
  }
  return out;
}

const SensorLine kDepth = {"m_depth", "m", 4, true};

TEST(FlightTrace, FlightAndScienceAreRowsOfOneClock) {
  const auto trace =
      traceOf({draftOf("dbd", {kDepth},
                       {{0, {{"m_depth", 1}}}, {4, {{"m_depth", 2}}}, {40, {{"m_depth", 3}}}}),
               draftOf("ebd", {{"sci_water_temp", "degc", 4, true}},
                       {{3, {{"sci_water_temp", 10}}},
                        {5, {{"sci_water_temp", 12}}},
                        {20, {{"sci_water_temp", 15}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->mission, "TEST.MI");
  EXPECT_EQ(trace->log->vehicle, "unit");
  EXPECT_EQ(trace->log->utc_s, kStart);
  EXPECT_EQ(column(*trace, "time"), (Values{0, 4, 20, 40}))
      << "science has a row where flight has none within 10 s";
  EXPECT_EQ(column(*trace, "sci_water_temp"), (Values{10, 11, 15, kNone}));
  EXPECT_EQ(unitOf(*trace, "sci_water_temp"), "degC");
  EXPECT_EQ(column(*trace, "m_depth")[2], 2.444444) << "on the line between two updates";
  EXPECT_EQ(eventsOf(*trace, "log").size(), 1U) << "both files are of one segment";
}

TEST(FlightTrace, NothingIsKnownInALongGap) {
  const auto trace = traceOf({draftOf("dbd", {kDepth, {"m_depth_state", "enum", 1, true}},
                                      {{0, {{"m_depth", 1}, {"m_depth_state", 1}}},
                                       {300, {{"m_depth", 2}}},
                                       {602, {{"m_depth", 4}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "time"), (Values{0, 300, 451, 602}));
  EXPECT_EQ(column(*trace, "m_depth"), (Values{1, 2, kNone, 4}));
  EXPECT_EQ(column(*trace, "state"), (Values{1, 1, kNone, kNone})) << "not known after it either";
  ASSERT_EQ(trace->log->gaps.size(), 1U) << "300 s is none";
  EXPECT_EQ(trace->log->gaps[0].from_s, 300);
  EXPECT_EQ(trace->log->gaps[0].to_s, 602);
  EXPECT_TRUE(trace->isGap(300, 451));
  EXPECT_TRUE(trace->isGap(451, 602));
  EXPECT_FALSE(trace->isGap(0, 300));
  EXPECT_FALSE(trace->isGap(0, 451));
  EXPECT_FALSE(trace->isGap(602, 610));
}

TEST(FlightTrace, RowsThatAreAskedForDoNotFillAGap) {
  const auto trace = traceOf({draftOf("dbd", {kDepth, {"m_depth_state", "enum", 1, true}},
                                      {{0, {{"m_depth", 1}, {"m_depth_state", 1}}},
                                       {400, {{"m_depth", 2}}},
                                       {800, {{"m_depth", 4}, {"m_depth_state", 2}}}})},
                             {kStart + 100, kStart + 300});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "time"), (Values{0, 100, 200, 300, 400, 600, 800}));
  EXPECT_EQ(column(*trace, "state"), (Values{1, kNone, kNone, kNone, kNone, kNone, 2}));
  ASSERT_EQ(trace->log->gaps.size(), 2U);
  EXPECT_TRUE(trace->isGap(200, 300));
  EXPECT_FALSE(trace->isGap(300, 600)) << "there is a record between them";
}

TEST(FlightTrace, BatteryChangesSlowly) {
  const auto trace = traceOf({draftOf(
      "dbd", {kDepth, {"m_battery", "volts", 4, true}, {"m_battery_inst", "volts", 4, true}},
      {{0, {{"m_depth", 1}, {"m_battery", 14}, {"m_battery_inst", 9}}},
       {200, {{"m_depth", 1}, {"m_battery_inst", 9}}},
       {400, {{"m_depth", 1}, {"m_battery", 13}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "m_battery"), (Values{14, 13.5, 13}));
  EXPECT_EQ(std::ranges::count(trace->columns, "m_battery", &support::TraceColumn::name), 1)
      << "m_battery_inst is for files without m_battery";
}

TEST(FlightTrace, FilesOfSeveralSegmentsAndMissionsAreOneFlight) {
  Draft first = draftOf("dbd", {kDepth}, {{0, {{"m_depth", 0}}}});
  Draft second = draftOf("dbd", {kDepth}, {{20, {{"m_depth", 0}}}});
  second.full_name = "unit-2024-183-2-8";
  // The same record again, at the same time.
  Draft third = draftOf("dbd", {kDepth}, {{20, {{"m_depth", 0}}}, {24, {{"m_depth", 0}}}});
  third.full_name = "unit-2024-183-2-9";
  const auto trace = traceOf({first, second, third});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "time"), (Values{0, 20, 24}));
  EXPECT_EQ(trace->mission, "TEST.MI");
  EXPECT_EQ(eventsOf(*trace, "log").size(), 3U);
}

TEST(FlightTrace, RecordsOfAnUnsetClockAreLeftOut) {
  const auto trace = traceOf(
      {draftOf("dbd", {kDepth},
               {{-kStart, {{"m_depth", 9}}}, {0, {{"m_depth", 1}}}, {1e12, {{"m_depth", 9}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "time"), Values{0});
}

TEST(FlightTrace, DepthIsFromPressureWhereItWasNotLogged) {
  const SensorLine pressure = {"m_pressure", "bar", 4, true};
  const auto trace =
      traceOf({draftOf("sbd", {kDepth, pressure},
                       {{0, {{"m_depth", 1}, {"m_pressure", 7}}},
                        {20, {{"m_pressure", 7}}},
                        {60, {{"m_pressure", 2}}},
                        {100, {{"m_pressure", -0.5}}}}),
               draftOf("tbd", {{"sci_water_pressure", "bar", 4, true}},
                       {{61, {{"sci_water_pressure", 9}}}, {140, {{"sci_water_pressure", 3}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "time"), (Values{0, 20, 60, 100, 140}));
  EXPECT_EQ(column(*trace, "m_depth"), (Values{1, 7.333333, 20, 0, 30}))
      << "10 m for each bar; m_depth is preferred; above the surface it is 0";
}

TEST(FlightTrace, WithoutDepthItIsAnError) {
  const auto trace =
      traceOf({draftOf("dbd", {{"m_pitch", "rad", 4, true}}, {{0, {{"m_pitch", 0.1}}}})});
  ASSERT_FALSE(trace);
  EXPECT_EQ(support::code(trace.error().id), "GL5204");
  const auto unset = traceOf({draftOf("dbd", {kDepth}, {{0, {{"m_depth", kUnset}}}})});
  ASSERT_FALSE(unset) << "an unset value is not a depth";
  const auto no_time = traceOf({draftOf("dbd", {kDepth}, {{-kStart, {{"m_depth", 1}}}})});
  ASSERT_FALSE(no_time);
  EXPECT_NE(no_time.error().message.find("no record has a valid time"), std::string::npos);
}

TEST(FlightTrace, UnsetValuesAreNotKnown) {
  const auto trace =
      traceOf({draftOf("dbd",
                       {kDepth,
                        {"m_water_depth", "m", 4, true},
                        {"c_wpt_lat", "lat", 8, true},
                        {"c_wpt_lon", "lon", 8, true},
                        {"m_pitch", "rad", 4, true}},
                       {{0,
                         {{"m_depth", 1},
                          {"m_water_depth", -1},
                          {"c_wpt_lat", kUnset},
                          {"c_wpt_lon", kUnset},
                          {"m_pitch", 0.1}}},
                        {4, {{"m_depth", 1}, {"m_water_depth", 40}, {"m_pitch", NAN}}},
                        {8, {{"m_depth", 1}, {"m_water_depth", 0}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "water_depth"), (Values{kNone, 40, kNone}));
  EXPECT_EQ(unitOf(*trace, "c_wpt_lat"), "none") << "a column without any value is left out";
  EXPECT_EQ(column(*trace, "m_pitch"), (Values{0.1, kNone, kNone}));
}

TEST(FlightTrace, PositionsAreDegreesAndMetres) {
  EXPECT_DOUBLE_EQ(degreesOf(5440.5), 54.675);
  EXPECT_DOUBLE_EQ(degreesOf(-12805.7932), -(128 + 5.7932 / 60));
  EXPECT_DOUBLE_EQ(degreesOf(-30), -0.5);
  EXPECT_TRUE(std::isnan(degreesOf(5460)));
  const std::vector<SensorLine> sensors = {
      kDepth, {"m_lat", "lat", 8, true}, {"m_lon", "lon", 8, true}};
  const auto trace =
      traceOf({draftOf("dbd", sensors,
                       {{0, {{"m_depth", 0}, {"m_lat", 5400}, {"m_lon", -600}}},
                        {30, {{"m_depth", 5}}},
                        {60, {{"m_depth", 9}, {"m_lat", 5400.03}, {"m_lon", -600}}},
                        // A GPS fix moves the dead-reckoned position by 1.1 km.
                        {64, {{"m_depth", 0}, {"m_lat", 5400.63}, {"m_lon", -600}}},
                        {68, {{"m_depth", 0}, {"m_lat", 5400.63}, {"m_lon", -559.99}}},
                        {72, {{"m_depth", 0}, {"m_lat", kUnset}, {"m_lon", kUnset}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "m_lat"), (Values{54, 54.00025, 54.0005, 54.0105, 54.0105, 54.0105}));
  const Values north = column(*trace, "dr_y"), east = column(*trace, "dr_x");
  EXPECT_NEAR(north[2], 0.0005 * 111306, 0.1) << "a degree of latitude at 54 N is 111,306 m";
  EXPECT_NEAR(east[4], 0.01 / 60 * 65578, 0.1) << "a degree of longitude there is 65,578 m";
  EXPECT_EQ(column(*trace, "dr_leg"), (Values{0, 0, 0, 1, 1, 1}));
}

TEST(FlightTrace, TheTrackEndsWherePositionsWereNotLogged) {
  const std::vector<SensorLine> sensors = {
      kDepth, {"m_lat", "lat", 8, true}, {"m_lon", "lon", 8, true}};
  const auto at = [](double time, double lat, double lon) {
    return Record{time, {{"m_depth", 0}, {"m_lat", lat}, {"m_lon", lon}}};
  };
  const auto trace = traceOf(
      {draftOf("dbd", sensors,
               {at(0, 5400, 17959.99), at(3590, 5400, -17959.99), at(7200, 5400, -17959.99)})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "dr_leg"), (Values{0, kNone, 0, kNone, 1})) << "3610 s are too long";
  EXPECT_NEAR(column(*trace, "dr_x")[2], 0.02 / 60 * 65578, 0.1) << "across the date line";
  const auto invalid = traceOf({draftOf("dbd", sensors, {at(0, 9100, 600)})});
  EXPECT_EQ(unitOf(*invalid, "m_lat"), "none") << "there is no latitude of 91 degrees";
}

TEST(FlightTrace, NoTrackLeadsToAFixThatMovesThePosition) {
  const std::vector<SensorLine> sensors = {
      kDepth, {"m_lat", "lat", 8, true}, {"m_lon", "lon", 8, true}};
  const auto trace = traceOf({draftOf("sbd", sensors,
                                      {{0, {{"m_depth", 0}, {"m_lat", 5400}, {"m_lon", 600}}},
                                       {50, {{"m_depth", 5}}},
                                       {100, {{"m_depth", 0}, {"m_lat", 5401}, {"m_lon", 600}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "m_lat"), (Values{54, kNone, 54.016667}));
}

TEST(FlightTrace, GpsFixesAreThoseThatTheVehicleAccepted) {
  const std::vector<SensorLine> sensors = {kDepth,
                                           {"m_gps_lat", "lat", 8, true},
                                           {"m_gps_lon", "lon", 8, true},
                                           {"m_gps_status", "enum", 1, true}};
  const auto trace = traceOf(
      {draftOf("dbd", sensors,
               {{0, {{"m_depth", 0}, {"m_gps_lat", 5400}, {"m_gps_lon", 600}, {"m_gps_status", 0}}},
                {4, {{"m_depth", 0}, {"m_gps_lat", 5500}, {"m_gps_lon", 600}, {"m_gps_status", 2}}},
                {8, {{"m_depth", 0}, {"m_gps_lat", kUnset}, {"m_gps_lon", kUnset}}},
                {12, {{"m_depth", 0}, {"m_gps_lat", 5400.06}, {"m_gps_lon", 600}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "m_gps_lat"), (Values{54, kNone, kNone, 54.001}));
  EXPECT_NEAR(column(*trace, "gps_y")[3], 0.001 * 111306, 0.1);
}

/// Dives of 10 m with the vehicle at the surface for 200 s between them.
std::vector<Record> dives(const std::vector<Record>& more) {
  std::map<double, std::map<std::string, double>> rows;
  for (double t = 0; t <= 600; t += 20) {
    const bool under = (t > 100 && t < 240) || t > 460;
    rows[t]["m_depth"] = under ? 10 : 0.3;
  }
  for (const Record& record : more) {
    rows[record.time_s].insert(record.values.begin(), record.values.end());
  }
  std::vector<Record> out;
  for (const auto& [time, values] : rows) {
    out.push_back({time, values});
  }
  return out;
}

TEST(FlightTrace, DivesAndSurfacingsAreEvents) {
  const auto trace = traceOf({draftOf("dbd", {kDepth}, dives({}))});
  ASSERT_TRUE(trace);
  EXPECT_EQ(eventsOf(*trace, "dive"),
            (std::vector<std::string>{"120 left the surface", "480 left the surface"}));
  EXPECT_EQ(eventsOf(*trace, "surface"), std::vector<std::string>{"240 at the surface"});
  EXPECT_EQ(eventsOf(*trace, "log"),
            std::vector<std::string>{"0 segment unit-2024-183-2-7 begins; mission TEST.MI"});
}

TEST(FlightTrace, OfTheCurrentsBetweenTwoDivesTheLastIsUsed) {
  const std::vector<SensorLine> sensors = {kDepth,
                                           {"m_water_vx", "m/s", 4, true},
                                           {"m_water_vy", "m/s", 4, true},
                                           {"m_gps_mag_var", "rad", 4, true}};
  constexpr double kQuarter = std::numbers::pi / 2;
  const auto trace = traceOf(
      {draftOf("dbd", sensors,
               dives({{60, {{"m_water_vx", 0.25}, {"m_water_vy", 0}, {"m_gps_mag_var", -kQuarter}}},
                      {260, {{"m_water_vx", 8}, {"m_water_vy", 8}}},
                      {300, {{"m_water_vx", 0}, {"m_water_vy", 0.5}}}}))});
  ASSERT_TRUE(trace);
  const Values east = column(*trace, "current_x"), north = column(*trace, "current_y");
  // The compass shows 90 degrees less than the true heading: what is east for it is south.
  EXPECT_EQ(east[2], kNone);
  EXPECT_EQ(east[3], 0);
  EXPECT_EQ(north[3], -0.25);
  EXPECT_EQ(north[14], -0.25) << "until the next estimate that is used";
  EXPECT_EQ(east[15], 0.5) << "and its north is east";
  EXPECT_EQ(north[15], 0);
  EXPECT_TRUE(trace->log->notes.empty());
}

TEST(FlightTrace, CurrentsAreTurnedByTheDeclinationOfTheirTime) {
  const std::vector<SensorLine> sensors = {kDepth,
                                           {"m_water_vx", "m/s", 4, true},
                                           {"m_water_vy", "m/s", 4, true},
                                           {"m_gps_mag_var", "rad", 4, true}};
  constexpr double kHalf = std::numbers::pi;
  const auto trace = traceOf({draftOf("dbd", sensors,
                                      dives({{40, {{"m_gps_mag_var", 0}}},
                                             {60, {{"m_water_vx", 0.25}, {"m_water_vy", 0}}},
                                             {280, {{"m_gps_mag_var", kHalf}}},
                                             {300, {{"m_water_vx", 0.25}, {"m_water_vy", 0}}},
                                             {320, {{"m_gps_mag_var", 0}}}}))});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "current_x")[4], 0.25);
  EXPECT_EQ(column(*trace, "current_x")[16], -0.25);
}

TEST(FlightTrace, WithoutCurrentsThereIsNoNote) {
  const auto trace = traceOf({draftOf("dbd", {kDepth}, {{0, {{"m_depth", 0}}}})});
  ASSERT_TRUE(trace);
  EXPECT_TRUE(trace->log->notes.empty());
}

TEST(FlightTrace, CurrentsWithoutDeclinationHaveANote) {
  const std::vector<SensorLine> sensors = {
      kDepth, {"m_final_water_vx", "m/s", 4, true}, {"m_final_water_vy", "m/s", 4, true}};
  const auto trace = traceOf(
      {draftOf("dbd", sensors,
               {{0, {{"m_depth", 0}, {"m_final_water_vx", 0.1}, {"m_final_water_vy", 0.2}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "current_y"), Values{0.2});
  ASSERT_EQ(trace->log->notes.size(), 1U);
  EXPECT_NE(trace->log->notes[0].find("magnetic north"), std::string::npos);
}

TEST(FlightTrace, StatesAreThoseOfTheDepthState) {
  const auto trace = traceOf({draftOf("dbd", {kDepth, {"m_depth_state", "enum", 1, true}},
                                      {{0, {{"m_depth", 0}, {"m_depth_state", 0}}},
                                       {4, {{"m_depth", 0}, {"m_depth_state", 1}}},
                                       {8, {{"m_depth", 0}}},
                                       {12, {{"m_depth", 0}, {"m_depth_state", 2}}},
                                       {16, {{"m_depth", 0}, {"m_depth_state", 3}}},
                                       {20, {{"m_depth", 0}, {"m_depth_state", 99}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "state"), (Values{0, 1, 1, 2, 3, kNone}));
  EXPECT_EQ(trace->state_names, (std::vector<std::string>{"surface", "dive", "climb", "hover"}));
  const auto other =
      traceOf({draftOf("dbd", {kDepth, {"cc_final_depth_state_mode", "enum", 1, true}},
                       {{0, {{"m_depth", 0}, {"cc_final_depth_state_mode", 2}}}})});
  EXPECT_EQ(column(*other, "state"), Values{2});
}

TEST(FlightTrace, AbortsAreEventsInWords) {
  const std::vector<SensorLine> sensors = {kDepth,
                                           {"x_mission_status", "enum", 1, true},
                                           {"m_present_secs_into_mission", "sec", 4, true}};
  const auto trace = traceOf({draftOf(
      "dbd", sensors,
      {{0, {{"m_depth", 0}, {"x_mission_status", 0}, {"m_present_secs_into_mission", 100}}},
       {4, {{"m_depth", 0}, {"x_mission_status", 7}, {"m_present_secs_into_mission", 104}}},
       {8, {{"m_depth", 0}, {"x_mission_status", 7}}},
       {12, {{"m_depth", 0}, {"x_mission_status", 50}}},
       {16, {{"m_depth", 0}, {"x_mission_status", -2}}},
       {20, {{"m_depth", 0}, {"x_mission_status", -1}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(eventsOf(*trace, "abort"),
            (std::vector<std::string>{"4 too deep; mission status 7",
                                      "12 for a reason that is not known; mission status 50"}));
  EXPECT_EQ(eventsOf(*trace, "log")[1], "16 the mission ended abnormally; mission status -2");
  EXPECT_EQ(eventsOf(*trace, "log")[2], "20 the mission ended normally; mission status -1");
  EXPECT_EQ(trace->events[1].mission_time_s, 104);
  EXPECT_EQ(missionStatusText(10), "the depth has not changed for too long");
  const auto other =
      traceOf({draftOf("dbd", {kDepth, {"cc_final_mission_status_mode", "enum", 1, true}},
                       {{0, {{"m_depth", 0}, {"cc_final_mission_status_mode", 24}}}})});
  EXPECT_EQ(eventsOf(*other, "abort"), std::vector<std::string>{"0 leak; mission status 24"});
}

TEST(FlightTrace, EventsAreInTheOrderOfTime) {
  const auto trace = traceOf(
      {draftOf("dbd", {kDepth, {"x_hit_a_waypoint", "bool", 1, true}},
               dives({{20, {{"x_hit_a_waypoint", 0}}}, {140, {{"x_hit_a_waypoint", 1}}}}))});
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->events.size(), 5U);
  EXPECT_TRUE(std::ranges::is_sorted(trace->events, {}, &support::TraceEvent::time_s));
}

TEST(FlightTrace, ALogThatBeginsUnderWaterDidNotLeaveTheSurface) {
  const auto trace =
      traceOf({draftOf("dbd", {kDepth}, {{0, {{"m_depth", 9}}}, {4, {{"m_depth", 1}}}})});
  ASSERT_TRUE(trace);
  EXPECT_TRUE(eventsOf(*trace, "dive").empty());
  EXPECT_EQ(eventsOf(*trace, "surface"), std::vector<std::string>{"4 at the surface"});
}

TEST(FlightTrace, ReachedWaypointsAreEvents) {
  const auto trace = traceOf({draftOf("dbd", {kDepth, {"x_hit_a_waypoint", "bool", 1, true}},
                                      {{0, {{"m_depth", 0}, {"x_hit_a_waypoint", 0}}},
                                       {4, {{"m_depth", 0}, {"x_hit_a_waypoint", 1}}},
                                       {8, {{"m_depth", 0}, {"x_hit_a_waypoint", 1}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(eventsOf(*trace, "behaviour"), std::vector<std::string>{"4 reached the waypoint"});
}

TEST(FlightTrace, CommandedAnglesAreThoseThatTheVehicleSteersFor) {
  const std::vector<SensorLine> sensors = {kDepth,
                                           {"c_heading", "rad", 4, true},
                                           {"c_pitch", "rad", 4, true},
                                           {"cc_final_heading_mode", "enum", 1, true},
                                           {"cc_final_pitch_mode", "enum", 1, true}};
  const auto record = [](double time, double heading_mode, double pitch_mode) {
    return Record{time,
                  {{"m_depth", 0},
                   {"c_heading", 1.5},
                   {"c_pitch", 0.25},
                   {"cc_final_heading_mode", heading_mode},
                   {"cc_final_pitch_mode", pitch_mode}}};
  };
  const auto trace = traceOf({draftOf(
      "dbd", sensors,
      {record(0, 0, 1), record(4, 1, 2), record(8, 2, 3), record(12, 4, 4), record(16, -1, -1)})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "c_heading"), (Values{1.5, 1.5, kNone, kNone, kNone}))
      << "modes 0 waypoint and 1 heading; not 2 roll, 4 fin";
  EXPECT_EQ(column(*trace, "c_pitch"), (Values{kNone, 0.25, 0.25, kNone, kNone}))
      << "modes 2 set once and 3 controlled; not 1 battery position, 4 fluid";
}

TEST(FlightTrace, HeadingsTurnTheShorterWay) {
  const double a = 6.2, b = 0.1;
  const auto trace = traceOf({draftOf("dbd", {kDepth, {"m_heading", "rad", 4, true}},
                                      {{0, {{"m_depth", 0}, {"m_heading", a}}},
                                       {4, {{"m_depth", 0}}},
                                       {8, {{"m_depth", 0}, {"m_heading", b}}}})});
  ASSERT_TRUE(trace);
  EXPECT_NEAR(column(*trace, "m_heading")[1], (a + b) / 2 - std::numbers::pi, 1e-5);
  const auto back = traceOf({draftOf("dbd", {kDepth, {"m_heading", "rad", 4, true}},
                                     {{0, {{"m_depth", 0}, {"m_heading", b}}},
                                      {6, {{"m_depth", 0}}},
                                      {8, {{"m_depth", 0}, {"m_heading", a}}}})});
  ASSERT_TRUE(back);
  EXPECT_NEAR(column(*back, "m_heading")[1], a + 0.25 * (b + 2 * std::numbers::pi - a), 1e-5)
      << "never below 0";
}

TEST(FlightTrace, PowerAndEnergyAreFromVoltageCurrentAndCharge) {
  const std::vector<SensorLine> sensors = {kDepth,
                                           {"m_battery", "volts", 4, true},
                                           {"m_coulomb_current", "amp", 4, true},
                                           {"m_coulomb_amphr", "amp-hrs", 4, true}};
  const auto record = [](double time, double amps, double charge) {
    return Record{time,
                  {{"m_depth", 0},
                   {"m_battery", 12},
                   {"m_coulomb_current", amps},
                   {"m_coulomb_amphr", charge}}};
  };
  const auto trace = traceOf(
      {draftOf("dbd", sensors,
               {record(0, 0.5, 100), record(4, 2, 100.5), record(8, 1, 0), record(12, 1, 0.25)})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "power"), (Values{6, 24, 12, 12}));
  EXPECT_EQ(column(*trace, "energy"), (Values{0, 6, 6, 9})) << "the counter was reset at 8 s";
  EXPECT_EQ(unitOf(*trace, "energy"), "Wh");
  const auto gap = traceOf({draftOf("dbd", sensors, {record(0, 0.5, 100), record(400, 0.5, 101)})});
  ASSERT_TRUE(gap);
  EXPECT_EQ(column(*gap, "energy").back(), 0) << "the log says nothing of a gap";
}

/// On the deck of a ship, 17 m/s fast, each position is a fix.
TEST(FlightTrace, FromFixToFixTheVehicleIsMoved) {
  const std::vector<SensorLine> sensors = {kDepth,
                                           {"m_lat", "lat", 8, true},
                                           {"m_lon", "lon", 8, true},
                                           {"m_gps_lat", "lat", 8, true},
                                           {"m_gps_lon", "lon", 8, true}};
  const auto record = [](double time, double lon, double fix) {
    return Record{
        time,
        {{"m_depth", 0}, {"m_lat", 5139}, {"m_lon", lon}, {"m_gps_lat", 5139}, {"m_gps_lon", fix}}};
  };
  const auto carried =
      traceOf({draftOf("dbd", sensors,
                       {record(0, -12805.0, -12805.0), record(4, -12804.9, -12804.9),
                        record(8, -12804.8, -12804.8)})});
  ASSERT_TRUE(carried);
  EXPECT_EQ(column(*carried, "dr_leg"), (Values{0, 0, 0}));
  const auto surfaced = traceOf(
      {draftOf("dbd", sensors, {record(0, -12805.0, -12805.5), record(4, -12804.9, -12804.9)})});
  ASSERT_TRUE(surfaced);
  EXPECT_EQ(column(*surfaced, "dr_leg"), (Values{0, 1})) << "the fix has moved the position";
}

TEST(FlightTrace, AltitudeIsNotKnownBetweenEchoes) {
  const auto trace = traceOf({draftOf("dbd", {kDepth, {"m_altitude", "m", 4, true}},
                                      {{0, {{"m_depth", 0}, {"m_altitude", 20}}},
                                       {20, {{"m_depth", 0}}},
                                       {60, {{"m_depth", 0}, {"m_altitude", 10}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "m_altitude"), (Values{20, kNone, 10}));
}

TEST(FlightTrace, OpticalInstrumentsKeepTheirNames) {
  const auto trace = traceOf(
      {draftOf("dbd", {kDepth}, {{0, {{"m_depth", 1}}}}),
       draftOf("ebd", {{"sci_flntu_chlor_units", "ug/l", 4, true}, {"sci_other", "nodim", 4, true}},
               {{0, {{"sci_flntu_chlor_units", 1.5}, {"sci_other", 1}}}})});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "sci_flntu_chlor_units"), Values{1.5});
  EXPECT_EQ(unitOf(*trace, "sci_flntu_chlor_units"), "ug/l");
  EXPECT_EQ(unitOf(*trace, "sci_other"), "none");
}

TEST(FlightTrace, RowsCanBeAskedFor) {
  const auto trace =
      traceOf({draftOf("dbd", {kDepth}, {{0, {{"m_depth", 0}}}, {40, {{"m_depth", 4}}}})},
              {kStart - 20, kStart + 5, kStart + 20, kStart + 99});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "time"), (Values{0, 20, 40})) << "during the log, and not near a record";
  EXPECT_EQ(column(*trace, "m_depth"), (Values{0, 2, 4}));
}

TEST(FlightTrace, PressureIsDepthInWhateverUnitItIs) {
  for (const auto& [unit, value] :
       {std::pair("bar", 1.5), std::pair("dbar", 15.0), std::pair("mbar", 1500.0)}) {
    const auto trace = traceOf({draftOf("ebd", {{"sci_water_pressure", unit, 8, true}},
                                        {{0, {{"sci_water_pressure", value}}}})});
    ASSERT_TRUE(trace) << unit;
    EXPECT_EQ(column(*trace, "m_depth"), Values{15}) << unit;
    EXPECT_EQ(column(*trace, "sci_water_pressure"), Values{1.5}) << unit;
    EXPECT_EQ(unitOf(*trace, "sci_water_pressure"), "bar");
  }
}

TEST(FlightTrace, ValuesInAnotherUnitAreNotDrawn) {
  auto later = draftOf("ebd", {{"sci_water_pressure", "dbar", 4, true}},
                       {{1000, {{"sci_water_pressure", 20}}}});
  later.full_name = "unit-2024-183-2-8";
  later.opened = "Tue_Jul__2_19:15:27_2024";
  const auto trace = traceOf(
      {draftOf("ebd", {{"sci_water_pressure", "bar", 4, true}}, {{0, {{"sci_water_pressure", 2}}}}),
       later});
  ASSERT_TRUE(trace);
  EXPECT_EQ(column(*trace, "sci_water_pressure").front(), 2);
  EXPECT_EQ(column(*trace, "sci_water_pressure").back(), kNone);
  EXPECT_EQ(column(*trace, "m_depth").front(), 20);
  EXPECT_EQ(column(*trace, "m_depth").back(), kNone);
}

TEST(FlightTrace, RecordsWithoutARightTimeAreNotDrawn) {
  std::vector<Record> records;
  for (int i = 0; i < 20; ++i) {
    records.push_back({i == 10 ? -kStart : 4.0 * i, {{"m_depth", i == 10 ? 500.0 : i}}});
  }
  const auto trace = traceOf({draftOf("dbd", {kDepth}, records)});
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->rowCount(), 19U);
  EXPECT_EQ(trace->log->utc_s, kStart);
  const Values depths = column(*trace, "m_depth");
  EXPECT_LT(*std::ranges::max_element(depths), 20);
  EXPECT_EQ(trace->log->notes, std::vector<std::string>{
                                   "1 record is left out, because of a time that cannot be right"});
}

TEST(FlightTrace, AWildFixIsNotDrawn) {
  const std::vector<SensorLine> sensors = {kDepth,
                                           {"m_gps_lat", "lat", 8, true},
                                           {"m_gps_lon", "lon", 8, true},
                                           {"m_lat", "lat", 8, true},
                                           {"m_lon", "lon", 8, true}};
  std::vector<Record> records;
  for (int i = 0; i < 6; ++i) {
    const double lon = i == 3 ? 512 : -7349.8;
    records.push_back({4.0 * i,
                       {{"m_depth", 0},
                        {"m_gps_lat", 3910.5},
                        {"m_gps_lon", lon},
                        {"m_lat", 3910.5},
                        {"m_lon", -7349.8}}});
  }
  const auto trace = traceOf({draftOf("dbd", sensors, records)});
  ASSERT_TRUE(trace);
  const Values lon = column(*trace, "m_gps_lon");
  EXPECT_EQ(lon.at(2), -73.83);
  EXPECT_EQ(lon.at(3), kNone);
  EXPECT_EQ(trace->log->notes,
            std::vector<std::string>{"1 GPS fix is left out, because of a position that cannot be "
                                     "right"});
}

TEST(FlightTrace, AGapOfDamageIsMarked) {
  std::vector<Record> records;
  for (int i = 0; i < 60; ++i) {
    records.push_back({4.0 * i, {{"m_depth", i}}});
  }
  std::string bytes = write(draftOf("dbd", {kDepth}, records));
  bytes.replace(bytes.size() / 2, 30, std::string(30, '\0'));
  const TestFolder folder;
  folder.write("a.dbd", bytes);
  SensorLists lists;
  const LogFiles logs = readLogFiles({folder.path()}, lists);
  ASSERT_EQ(logs.failures.size(), 1U);
  const auto trace = flightTrace(merge(logs.files, flightTraceSensors()));
  ASSERT_TRUE(trace);
  ASSERT_EQ(trace->log->gaps.size(), 1U);
  const support::TraceGap gap = trace->log->gaps[0];
  EXPECT_GT(gap.to_s - gap.from_s, 8);
  EXPECT_LT(gap.to_s - gap.from_s, 40);
  EXPECT_EQ(trace->log->notes,
            std::vector<std::string>{"1 gap is in the records where a file is damaged"});
  EXPECT_EQ(column(*trace, "m_depth").back(), 59);
}

TEST(FlightTrace, RealFlightsAreWhatTheyWere) {
  const std::filesystem::path folder =
      std::filesystem::path(GLIDER_SOURCE_DIR) / "../shared/data/dbd";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "the real data files are not here: " << folder;
  }
  SensorLists lists({folder / "cac"});
  const LogFiles logs = readLogFiles(
      {folder / "comet-2019-222-02-154.dbd", folder / "comet-2019-222-02-154.ebd"}, lists);
  const auto trace = flightTrace(merge(logs.files, flightTraceSensors()));
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->mission, "NSB3.MI");
  EXPECT_EQ(eventsOf(*trace, "dive"), std::vector<std::string>{"137 left the surface"});
  EXPECT_EQ(eventsOf(*trace, "surface"), std::vector<std::string>{"9947 at the surface"});
  EXPECT_EQ(eventsOf(*trace, "abort").size(), 0U);
  for (const double lat : column(*trace, "m_lat")) {
    EXPECT_TRUE(lat == kNone || (lat > 54.28 && lat < 54.35)) << lat;
  }
  const Values energy = column(*trace, "energy");
  EXPECT_NEAR(*std::ranges::max_element(energy), 7.7, 0.1) << "0.565 Ah at 13.7 V";
  const LogFiles days = readLogFiles(
      {folder / "comet-2019-218-00-034.dbd", folder / "comet-2019-222-02-154.dbd"}, lists);
  const auto both = flightTrace(merge(days.files, flightTraceSensors()));
  ASSERT_TRUE(both);
  const Values of_both = column(*both, "energy");
  EXPECT_NEAR(*std::ranges::max_element(of_both), 7.7 + 14.1, 0.1) << "days lie between the files";
}

}  // namespace
}  // namespace glider::slocum
