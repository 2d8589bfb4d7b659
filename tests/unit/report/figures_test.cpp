// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/figures.h"

#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

namespace glider::report {
namespace {

TEST(Figures, ListsEachYo) {
  const auto trace =
      smallTrace({{"time", "s"}, {"m_depth", "m"}},
                 {{0, 0}, {10, 5}, {110, 25}, {200, 7}, {300, 27}, {410, 5}, {420, 1}});
  const std::vector<Yo> yos = yosOf(trace);
  ASSERT_EQ(yos.size(), 2U);
  EXPECT_EQ(yos.size(), flightFigures(trace).yos);
  EXPECT_DOUBLE_EQ(yos[0].start_s, 0);
  EXPECT_DOUBLE_EQ(yos[0].duration_s, 200);
  EXPECT_DOUBLE_EQ(yos[0].deepest_m, 25);
  EXPECT_DOUBLE_EQ(yos[0].down_mps, 25.0 / 110);
  EXPECT_DOUBLE_EQ(yos[0].up_mps, 18.0 / 90);
  EXPECT_FALSE(yos[0].surfaced);
  EXPECT_DOUBLE_EQ(yos[1].start_s, 200);
  EXPECT_DOUBLE_EQ(yos[1].down_mps, 0.2);
  EXPECT_DOUBLE_EQ(yos[1].up_mps, 26.0 / 120);
  EXPECT_TRUE(yos[1].surfaced) << "the last one ends at 1 m";
  EXPECT_EQ(nlohmann::json::parse(yosToJson(yos)).at(1).at("surfaced"), true);
}

/// 10 m in 50 s to both sides; it waits at the surface, where waves move it, before and after.
TEST(Figures, TheRatesOfAYoAreWithoutItsWaitsAtTheSurface) {
  const auto trace = smallTrace({{"time", "s"}, {"m_depth", "m"}}, {{0, 0.1},
                                                                    {500, 0.3},
                                                                    {1000, 0.5},
                                                                    {1050, 10.5},
                                                                    {1100, 0.5},
                                                                    {1500, 0.2},
                                                                    {2500, 0.1},
                                                                    {2600, 0.4},
                                                                    {2650, 10.4},
                                                                    {2700, 0.4}});
  const std::vector<Yo> yos = yosOf(trace);
  ASSERT_EQ(yos.size(), 2U);
  EXPECT_DOUBLE_EQ(yos[0].down_mps, 0.2);
  EXPECT_DOUBLE_EQ(yos[0].up_mps, 0.2);
  EXPECT_DOUBLE_EQ(yos[0].duration_s, 2500) << "to the next";
  EXPECT_DOUBLE_EQ(yos[1].down_mps, 0.2);
}

TEST(Figures, EnergyIsRelatedToThePack) {
  auto trace = smallTrace({{"time", "s"}, {"energy", "Wh"}}, {{0, 0}, {43200, 10}});
  EXPECT_TRUE(std::isnan(flightFigures(trace).energy.capacity_Wh)) << "of a log it is not known";
  trace.battery = {1000, 90};
  const EnergyFigures energy = flightFigures(trace).energy;
  EXPECT_DOUBLE_EQ(energy.used_Wh, 10);
  EXPECT_DOUBLE_EQ(energy.to_go_Wh, 900);
  EXPECT_DOUBLE_EQ(energy.days_left, 45) << "10 Wh in half a day";
  EXPECT_FALSE(energy.partly_known);
}

TEST(Figures, TheRateIsThatOfTheTimeInWhichTheEnergyIsKnown) {
  auto trace = smallTrace({{"time", "s"}, {"energy", "Wh"}},
                          {{0, kUnknown}, {43200, 0}, {64800, 4}, {86400, 10}});
  trace.battery = {1000, 90};
  const EnergyFigures energy = flightFigures(trace).energy;
  EXPECT_DOUBLE_EQ(energy.known_s, 43200);
  EXPECT_TRUE(energy.partly_known);
  EXPECT_DOUBLE_EQ(energy.days_left, 45);
  trace.log = support::VehicleLog{"comet", 0, "", {}, {{64800, 86400}}};
  EXPECT_DOUBLE_EQ(flightFigures(trace).energy.known_s, 21600) << "not in a gap";
}

/// In a log of 1000 s, records of the energy that begin `late_s` after the others.
bool isPartlyKnown(double late_s) {
  const auto trace = smallTrace({{"time", "s"}, {"energy", "Wh"}},
                                {{0, kUnknown}, {late_s, 0}, {500, 4}, {1000, 10}});
  const FlightFigures figures = flightFigures(trace);
  const auto json = nlohmann::json::parse(figuresToJson(figures));
  EXPECT_EQ(json.at("energy").at("partlyKnown"), figures.energy.partly_known);
  return figures.energy.partly_known;
}

TEST(Figures, TheEnergyIsPartlyKnownIfLessThan95Percent) {
  EXPECT_FALSE(isPartlyKnown(40));
  EXPECT_FALSE(isPartlyKnown(50));
  EXPECT_TRUE(isPartlyKnown(60));
}

TEST(Figures, TheTracksAreApartWhereTheyAreFarthest) {
  const auto trace = smallTrace(
      {{"time", "s"}, {"true_x", "m"}, {"true_y", "m"}, {"m_x_lmc", "m"}, {"m_y_lmc", "m"}},
      {{0, 0, 0, 0, 0}, {4, 10, 0, 13, 4}, {8, 20, 0, 20, 1}, {12, 30, 0, kUnknown, 0}});
  EXPECT_DOUBLE_EQ(flightFigures(trace).apart_m, 5);
}

TEST(Figures, CountsVisitsAndTimeOfEachState) {
  auto trace =
      smallTrace({{"time", "s"}, {"state", "id"}},
                 {{0, kUnknown}, {4, 0}, {8, 0}, {12, 1}, {20, 0}, {24, kUnknown}, {30, kUnknown}});
  trace.state_names = {"search", "track"};
  const FlightFigures figures = flightFigures(trace);
  ASSERT_EQ(figures.states.size(), 2U);
  EXPECT_EQ(figures.states[0].name, "search");
  EXPECT_EQ(figures.states[0].stretches, 2U);
  EXPECT_DOUBLE_EQ(figures.states[0].time_s, 12);
  EXPECT_EQ(figures.states[1].stretches, 1U);
  EXPECT_DOUBLE_EQ(figures.states[1].time_s, 8);
  EXPECT_DOUBLE_EQ(figures.layered_s, 10);
  EXPECT_DOUBLE_EQ(figures.duration_s, 30);
}

TEST(Figures, AGapOfALogIsTimeInNoState) {
  auto trace = smallTrace({{"time", "s"}, {"state", "id"}},
                          {{0, 0}, {4, 1}, {8, kUnknown}, {2000, kUnknown}, {4000, 0}, {4010, 0}});
  trace.state_names = {"surface", "dive"};
  trace.log.emplace().gaps = {{8, 4000}};
  const FlightFigures figures = flightFigures(trace);
  ASSERT_EQ(figures.states.size(), 2U);
  EXPECT_DOUBLE_EQ(figures.states[0].time_s, 14);
  EXPECT_DOUBLE_EQ(figures.states[1].time_s, 4);
  EXPECT_DOUBLE_EQ(figures.layered_s, 0) << "not one whose state is unknown either";
  EXPECT_DOUBLE_EQ(figures.gaps_s, 3992);
  EXPECT_DOUBLE_EQ(figures.duration_s, 4010);
  EXPECT_EQ(nlohmann::json::parse(figuresToJson(figures)).at("gaps"), 3992);
}

TEST(Figures, AMissionWithoutStatesIsNotLayeredControl) {
  const auto trace =
      smallTrace({{"time", "s"}, {"hook_active", ""}}, {{0, 0}, {4, 1}, {12, 0}, {14, 0}});
  const FlightFigures figures = flightFigures(trace);
  EXPECT_TRUE(figures.states.empty());
  EXPECT_DOUBLE_EQ(figures.stateless_s, 8);
  EXPECT_DOUBLE_EQ(figures.layered_s, 6);
}

TEST(Figures, AStateThatTheTraceDoesNotNameHasItsNumber) {
  const auto trace = smallTrace({{"time", "s"}, {"state", "id"}}, {{0, 7}, {4, -1}, {8, 1e300}});
  const FlightFigures figures = flightFigures(trace);
  ASSERT_EQ(figures.states.size(), 3U);
  EXPECT_EQ(figures.states[0].name, "state -1");
  EXPECT_EQ(figures.states[1].name, "state 7");
}

TEST(Figures, AYoIsADiveAndAClimbOfAtLeastTwoMetres) {
  const auto trace = smallTrace({{"time", "s"}, {"m_depth", "m"}}, {{0, 0},
                                                                    {1, 5},
                                                                    {2, kUnknown},
                                                                    {3, 10},
                                                                    {4, 9},
                                                                    {5, 10.5},
                                                                    {6, 8},
                                                                    {7, 3},
                                                                    {8, 4},
                                                                    {9, 3.5},
                                                                    {10, 9},
                                                                    {11, 7.2}});
  const FlightFigures figures = flightFigures(trace);
  EXPECT_EQ(figures.yos, 1U) << "ripples of 1 m and the last, half-climbed dive are none";
  EXPECT_DOUBLE_EQ(figures.deepest_m, 10.5);
  EXPECT_DOUBLE_EQ(figures.shallowest_m, 0);
}

TEST(Figures, DistanceFollowsTheTrueTrackAndPassesOverGaps) {
  const auto trace = smallTrace(
      {{"time", "s"}, {"true_x", "m"}, {"true_y", "m"}, {"m_x_lmc", "m"}, {"m_y_lmc", "m"}},
      {{0, 0, 0, 0, 0}, {4, 3, 4, 0, 0}, {8, kUnknown, 4, 0, 0}, {12, 6, 0, 99, 99}});
  const FlightFigures figures = flightFigures(trace);
  EXPECT_EQ(figures.track, TrackSource::True);
  EXPECT_DOUBLE_EQ(figures.distance_m, 10);
  EXPECT_DOUBLE_EQ(figures.made_good_m, 6);
}

TEST(Figures, WithoutATrueTrackTheDeadReckonedOneServes) {
  const auto trace = smallTrace(
      {{"time", "s"}, {"true_x", "m"}, {"true_y", "m"}, {"m_x_lmc", "m"}, {"m_y_lmc", "m"}},
      {{0, kUnknown, kUnknown, 0, 0}, {4, kUnknown, kUnknown, 5, 12}});
  const FlightFigures figures = flightFigures(trace);
  EXPECT_EQ(figures.track, TrackSource::DeadReckoned);
  EXPECT_DOUBLE_EQ(figures.distance_m, 13);
}

TEST(Figures, AFixThatMovesThePositionOfALogIsNoDistance) {
  const auto trace = smallTrace({{"time", "s"}, {"dr_x", "m"}, {"dr_y", "m"}, {"dr_leg", ""}},
                                {{0, 0, 0, 0}, {4, 3, 4, 0}, {8, 503, 4, 1}, {12, 503, 5, 1}});
  const FlightFigures figures = flightFigures(trace);
  EXPECT_DOUBLE_EQ(figures.distance_m, 6);
  EXPECT_DOUBLE_EQ(figures.made_good_m, std::hypot(3, 5)) << "3, 4 before the fix, 0, 1 after it";
  EXPECT_EQ(figures.track, TrackSource::DeadReckoned);
}

TEST(Figures, TheTitleOfALogNamesTheVehicle) {
  support::Trace trace;
  trace.mission = "SPIRAL.MI";
  EXPECT_EQ(flightTitle(trace), "SPIRAL.MI");
  trace.log.emplace().vehicle = "comet";
  EXPECT_EQ(flightTitle(trace), "comet: SPIRAL.MI");
}

TEST(Figures, WhatIsNotThereIsNullInJson) {
  const auto json = nlohmann::json::parse(figuresToJson(flightFigures({})));
  for (const char* key : {"duration", "deepest", "distance", "layered", "warmest"}) {
    EXPECT_TRUE(json.at(key).is_null()) << key;
  }
  EXPECT_EQ(json.at("track"), "none");
  EXPECT_EQ(json.at("yos"), 0);
}

}  // namespace
}  // namespace glider::report
