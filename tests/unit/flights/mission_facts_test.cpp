// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/mission_facts.h"

#include "flights/launch_choice.h"
#include "flights/logged_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace glider::flights {
namespace {

using support::EventId;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

constexpr const char* kMission = R"(mission facts

const home = 39.175 N 73.835 W
const far  = 39.2 N 73.8 W
param watch: length = 400 m in 200 m .. 5 km
require exit within 2 h

always
  case missiontime >= 1 h exit

state look
begin
  flightprofile yo(5 m, 30 m, 26 deg, 26 deg)
  sensors       missiontime, depth, chlorophyll, roll
  events
    case distance(home) > 2 * watch goto leg(far)
    case highest(chlorophyll, 5 min) > 2 do log "bloom, at", depth, chlorophyll, pitch end stay
end

state leg(corner: position)
begin
  flightroute   nav(corner)
  flightprofile yo(5 m, 30 m, 26 deg, 26 deg)
  events
    case distance(corner) < 60 m || temp > 20 degC goto look
end
)";

compiler::Optimised compiled(const char* text = kMission) {
  auto compilation = compiler::compileText("facts.mission", text);
  EXPECT_TRUE(compilation);
  EXPECT_NE(compilation->checked, nullptr);
  return compiler::optimise(compilation->checked);
}

support::MissionFacts factsWith(std::vector<std::string> settings) {
  const compiler::Optimised mission = compiled();
  const auto parameters = chooseParameters(mission.checked->mission(), {std::move(settings), ""});
  EXPECT_TRUE(parameters);
  return missionFacts(mission, *parameters);
}

TEST(MissionFacts, ListsSensorsInTheOrderOfTheText) {
  EXPECT_EQ(factsWith({}).listed,
            (std::vector<std::string>{"m_depth", "sci_flbbcd_chlor_units", "m_roll"}))
      << "a clock is not a sensor";
}

TEST(MissionFacts, ConditionsOfCasesComeBeforeThoseOfProfiles) {
  const auto read = factsWith({}).read;
  const std::vector<std::string> expected = {"m_lat", "m_lon", "sci_flbbcd_chlor_units",
                                             "sci_water_temp", "m_depth"};
  ASSERT_GE(read.size(), expected.size());
  EXPECT_EQ(std::vector<std::string>(read.begin(), read.begin() + 5), expected);
}

TEST(MissionFacts, PlacesHaveTheNamesOfConstants) {
  const auto places = factsWith({}).places;
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].name, "home");
  EXPECT_DOUBLE_EQ(places[0].latitude_deg, 39.175);
  EXPECT_DOUBLE_EQ(places[0].longitude_deg, -73.835);
  EXPECT_EQ(places[1].name, "far");
}

TEST(MissionFacts, APositionThatIsAParameterIsAPlace) {
  auto compilation = compiler::compileText("target.mission", R"(mission target
param limit: angle = 20 deg
param target: position = 39 10.5 N 73 49.0 W
state s
begin
  flightroute nav(target)
  flightprofile yo(5 m, 30 m)
  sensors missiontime
  events
    case missiontime > 30 min exit
end
)");
  ASSERT_TRUE(compilation);
  ASSERT_NE(compilation->checked, nullptr);
  const compiler::Optimised mission = compiler::optimise(compilation->checked);
  const auto places = missionFacts(mission, {0.3, 39.5, -73.5}).places;
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].name, "target");
  EXPECT_EQ(places[0].latitude_deg, 39.5) << "as it was set at launch";
  EXPECT_EQ(places[0].longitude_deg, -73.5);
}

TEST(MissionFacts, ThePointsOfAPathArePlacesInItsOrder) {
  auto compilation = compiler::compileText("paths.mission", R"(mission paths

const track: path = [39.175 N 73.835 W, 39.2 N 73.8 W]

state look
begin
  flightroute   along(track, 100 m)
  flightprofile yo(5 m, 30 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case routedone              goto back
    case missiontime >= 1 h     exit
end

state back
begin
  flightroute   along([39.21 N 73.81 W, 39.175 N 73.835 W], 100 m)
  flightprofile yo(5 m, 30 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 1 h exit
end
)");
  ASSERT_TRUE(compilation);
  ASSERT_NE(compilation->checked, nullptr);
  const compiler::Optimised mission = compiler::optimise(compilation->checked);
  const auto places = missionFacts(mission, {}).places;
  ASSERT_EQ(places.size(), 4U);
  EXPECT_EQ(places[0].name, "track 1");
  EXPECT_DOUBLE_EQ(places[0].latitude_deg, 39.175);
  EXPECT_EQ(places[1].name, "track 2");
  EXPECT_DOUBLE_EQ(places[1].longitude_deg, -73.8);
  EXPECT_EQ(places[2].name, "back 1") << "a path without a name has that of its state";
  EXPECT_DOUBLE_EQ(places[2].latitude_deg, 39.21);
}

TEST(MissionFacts, AWatchCircleHasTheRadiusOfTheLaunch) {
  const auto watched = factsWith({"watch=1km"}).watch_circles;
  ASSERT_EQ(watched.size(), 2U);
  EXPECT_DOUBLE_EQ(watched[0].radius_m, 2000) << "2 * watch";
  EXPECT_DOUBLE_EQ(watched[0].latitude_deg, 39.175);
  EXPECT_DOUBLE_EQ(watched[1].radius_m, 60);
  EXPECT_DOUBLE_EQ(watched[1].latitude_deg, 39.2) << "the place that the transition passes";
}

support::Trace noted(const std::vector<std::string>& notes) {
  support::Trace trace;
  trace.columns = {{"time", "s"}, {"m_depth", "m"}, {"sci_flbbcd_chlor_units", "ug/L"}};
  trace.rows = {0, 1, 2, 4, 1, 2, 8, 1, 2};
  double time = 3;
  for (const std::string& note : notes) {
    trace.events.push_back(support::makeEvent(time, EventId::Note, {note}));
    time += 4;
  }
  return trace;
}

TEST(LoggedValues, AreColumnsWithUnits) {
  support::Trace trace = noted({"bloom, at 11.5 2.25 -0.5", "another 1 2 3"});
  addLoggedValues(compiled(), trace);
  ASSERT_EQ(trace.columns.size(), 6U);
  EXPECT_EQ(trace.columns[3].name, "log_bloom_at_depth") << "no comma: it is a field of the CSV";
  EXPECT_EQ(trace.columns[3].unit, "m");
  EXPECT_EQ(trace.columns[4].unit, "ug/L") << "a plain number to the language";
  EXPECT_EQ(trace.columns[5].unit, "rad");
  EXPECT_EQ(trace.at(1, 3), 11.5) << "the first row at or after 3 s";
  EXPECT_EQ(trace.at(1, 4), 2.25);
  EXPECT_EQ(trace.at(1, 5), -0.5);
  EXPECT_TRUE(std::isnan(trace.at(0, 3)));
  EXPECT_TRUE(std::isnan(trace.at(2, 3))) << "another note is not this statement's";
  ASSERT_EQ(trace.facts.logged.size(), 3U);
  EXPECT_EQ(trace.facts.logged[1].text, "bloom, at");
  EXPECT_EQ(trace.facts.logged[1].value, "chlorophyll");
}

TEST(LoggedValues, OfAWindowHaveTheUnitOfItsReadingsAndHalvesOfAPlaceTheirNames) {
  auto compilation = compiler::compileText("w.mission", R"(mission w
state s
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime, depth, chlorophyll, lat, lon
  events
    case missiontime > 1 h do
      log "peak", highest(chlorophyll, 2 min), slope(chlorophyll, 10 m of depth), here
    end stay
end
)");
  ASSERT_TRUE(compilation && compilation->checked);
  support::Trace trace = noted({"peak 4.5 0.25 39.17 -73.83"});
  addLoggedValues(compiler::optimise(compilation->checked), trace);
  ASSERT_EQ(trace.columns.size(), 7U);
  EXPECT_EQ(trace.columns[3].unit, "ug/L");
  EXPECT_NE(trace.columns[4].unit, "ug/L") << "a slope";
  EXPECT_EQ(trace.columns[5].name, "log_peak_here_latitude");
  EXPECT_EQ(trace.columns[6].name, "log_peak_here_longitude");
  EXPECT_EQ(trace.facts.logged[3].value, "here longitude");
}

TEST(LoggedValues, AreShownRoundedWithTheirUnits) {
  support::Trace trace = noted({"bloom, at 11.7794151306 2.61221814156 -0.5",
                                "bloom, at unknown 123456.789 0", "another 1.23456789012"});
  addLoggedValues(compiled(), trace);
  EXPECT_EQ(shownTextOf(trace.events[0]), "bloom, at 11.779 m, 2.6122 ug/L, -28.6 deg");
  EXPECT_EQ(shownTextOf(trace.events[1]), "bloom, at unknown, 123457 ug/L, 0.0 deg");
  EXPECT_EQ(shownTextOf(trace.events[2]), "another 1.23456789012") << "not of this mission";
  EXPECT_EQ(textOf(trace.events[0]), "bloom, at 11.7794151306 m 2.61221814156 ug/L -0.5 rad")
      << "events.csv keeps all digits, with units";
}

/// A note for the vehicle holds 60 bytes.
TEST(LoggedValues, WhatTheVehicleDidNotReceiveIsInTheMissionsOwnLog) {
  const std::string cut = "bloom, at 1.23456789012e-05 2.34567890123e-05 -3.45678901234e-0";
  support::Trace trace = noted({"bloom, at 1 2 3", cut.substr(0, 60), cut.substr(0, 60)});
  ASSERT_EQ(std::get<std::string>(trace.events[1].values[0]).size(), 60U);
  trace.events[0].mission_time_s = trace.events[1].mission_time_s = 8;
  trace.events[2].mission_time_s = 9;
  trace.notes = {{8, "bloom, at", {1, 2, 3}},
                 {8, "another", {1, 2, 3}},
                 {8, "bloom, at", {1.234567890123e-5, 2.345678901234e-5, -3.45678901234e-5}}};
  addLoggedValues(compiled(), trace);
  EXPECT_EQ(trace.at(1, 3), 1) << "the first row at or after 3 s";
  EXPECT_EQ(trace.at(2, 3), 1.23456789012e-05) << "with 12 digits, as a note";
  EXPECT_EQ(textOf(trace.events[0]), "bloom, at 1 m 2 ug/L 3 rad");
  EXPECT_EQ(textOf(trace.events[1]),
            "bloom, at 1.23456789012e-05 m 2.34567890123e-05 ug/L -3.45678901234e-05 rad")
      << "not the first note of that time";
  EXPECT_EQ(textOf(trace.events[2]), cut.substr(0, 60)) << "it is of another time";
}

TEST(LoggedValues, WhatIsUnknownOrCutOffIsNoValue) {
  support::Trace trace = noted({"bloom, at unknown 2.5 0.1", "bloom, at 1 2"});
  addLoggedValues(compiled(), trace);
  EXPECT_TRUE(std::isnan(trace.at(1, 3)));
  EXPECT_EQ(trace.at(1, 4), 2.5);
  EXPECT_TRUE(std::isnan(trace.at(2, 3))) << "the statement has three values";
  support::Trace empty;
  addLoggedValues(compiled(), empty);
  EXPECT_TRUE(empty.columns.empty());
}

TEST(FlownPromises, SayWhatTheFlightDid) {
  const compiler::Optimised mission = compiled();
  const RequirementWatch watch(mission);
  const auto held = flownPromises(watch, *mission.checked, {});
  ASSERT_EQ(held.size(), 1U);
  EXPECT_EQ(held[0].text, "require exit within 2 h");
  EXPECT_EQ(held[0].verdict, support::Verdict::Held);
  const auto violated =
      flownPromises(watch, *mission.checked, {{{0, 7204, 7210, "look", "still flying", ""}}, {}});
  EXPECT_EQ(violated[0].verdict, support::Verdict::Violated);
  EXPECT_EQ(violated[0].vehicle_time_s, 7210);
  const auto cut = flownPromises(watch, *mission.checked, {{}, {{0, "the flight ended before"}}});
  EXPECT_EQ(cut[0].verdict, support::Verdict::Undecided);
  EXPECT_EQ(cut[0].words, "the flight ended before");
  RequirementWatch departed(mission);
  departed.depart(100);
  EXPECT_EQ(flownPromises(departed, *mission.checked, {})[0].verdict, support::Verdict::NotChecked);
}

TEST(MissionFacts, HaveTheBoundOfTheEnergyIfTheParametersAreTheDefaults) {
  const auto mission = compiled(
      "mission m\nparam hours: time = 2 h in 1 h .. 9 h\nstate fly\nbegin\n"
      "  flightprofile yo(5 m, 30 m)\n  sensors missiontime, depth\n  events\n"
      "    case missiontime > hours exit\nend\n");
  const auto most = missionFacts(mission, {7200}).at_most;
  ASSERT_FALSE(most.empty());
  double sum = 0;
  for (const support::Consumer& one : most) {
    sum += one.used_Wh;
  }
  EXPECT_GT(sum, 2 * 4.5);  // W of hotel and SBC
  EXPECT_LT(sum, 2 * 20);
  EXPECT_TRUE(missionFacts(mission, {9000}).at_most.empty());
}

}  // namespace
}  // namespace glider::flights
