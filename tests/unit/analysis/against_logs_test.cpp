// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A mission along data files: what is expected is computed by hand from ir/README.md and the
// records. Records are 4 s apart unless a test says otherwise.

#include "tests/unit/analysis/log_bench.h"

#include <gmock/gmock.h>

namespace glider::analysis {
namespace {

using report::AgainstLogs;
using report::Flicker;
using report::FollowedStep;
using report::LoggedCase;
using report::LoggedFiring;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNothing = LogBench::kNothing;

/// A state `a` with these cases, which read `sensors`, and a state `b`.
std::string watching(const std::string& cases, const std::string& sensors) {
  return "state a\nbegin\n  flightprofile yo(3 m, 20 m, 26 deg, 26 deg)\n  sensors " + sensors +
         "\n  events\n    " + cases +
         "\nend\nstate b\nbegin\n  flightprofile yo(3 m, 20 m, 26 deg, 26 deg)\n"
         "  sensors missiontime, depth\n  events\n    case depth < 2 m exit\n"
         "    case missiontime > 10 h exit\nend\n";
}

/// Seconds since the first tick of each firing.
std::vector<double> timesOf(const LoggedCase& one) {
  std::vector<double> times;
  for (const LoggedFiring& firing : one.firings) {
    times.push_back(firing.at.time_s - LogBench::kBegin);
  }
  return times;
}

const report::LoggedSensor& sensorOf(const AgainstLogs& against, const std::string& name) {
  return *std::ranges::find(against.sensors, name, &report::LoggedSensor::name);
}

std::vector<std::string> kindsOf(const AgainstLogs& against) {
  std::vector<std::string> kinds;
  for (const FollowedStep& step : against.followed) {
    kinds.push_back(std::string(wordOf(step.kind)) + " " + step.from + ">" + step.to);
  }
  return kinds;
}

TEST(AgainstLogs, CountsEachTimeThatAGuardBecomesTrueOnce) {
  LogBench bench;
  bench.dive({1, 5, 11, 12, 13, 8, 11, 3});
  const AgainstLogs against = bench.run(watching("case depth > 10 m goto b", "depth"));
  EXPECT_EQ(against.ticks, 7U);
  const LoggedCase& one = against.cases.at(0);
  EXPECT_EQ(one.guard, "depth > 10 m");
  EXPECT_EQ(one.transition, "goto b");
  EXPECT_THAT(timesOf(one), ElementsAre(8, 24));
  EXPECT_EQ(one.true_ticks, 4U);
  EXPECT_EQ(one.known_ticks, 7U);
  EXPECT_EQ(one.firings.at(0).at.depth_m, 11);
  EXPECT_EQ(one.firings.at(0).at.utc, "2024-07-02 18:55:35");
  EXPECT_DOUBLE_EQ(one.firings.at(1).at.hours, 24.0 / 3600);
  EXPECT_EQ(one.firings.at(1).values.at(0).value, 11);
  EXPECT_EQ(one.firings.at(1).values.at(0).unit, "m");
  EXPECT_TRUE(one.flickers.empty());
}

/// E6: the tick that enters the state tries no guard.
TEST(AgainstLogs, TriesNoGuardOnTheFirstTick) {
  LogBench bench;
  bench.dive({11, 5, 5});
  const AgainstLogs against = bench.run(watching("case depth > 10 m goto b", "depth"));
  EXPECT_TRUE(against.cases.at(0).firings.empty());
  EXPECT_EQ(against.cases.at(0).known_ticks, 2U);
}

/// A tick, 2: a reading older than stale_after (20 s) is unknown.
TEST(AgainstLogs, AStaleReadingIsUnknown) {
  LogBench bench;
  bench.dive(std::vector<double>(11, 5.0));
  bench.science({2}, {{"sci_water_temp", {21}}});
  const AgainstLogs against = bench.run(watching("case temp > 20 degC goto b", "temp"));
  // It arrives at 4 s, and is too old from 28 s on: known at 4, 8, 12, 16, 20 and 24 s.
  EXPECT_EQ(against.cases.at(0).known_ticks, 6U);
  EXPECT_EQ(against.cases.at(0).true_ticks, 6U);
  EXPECT_THAT(timesOf(against.cases.at(0)), ElementsAre(4));
  EXPECT_EQ(sensorOf(against, "temp").updates, 1U);
  EXPECT_EQ(sensorOf(against, "temp").known_ticks, 6U);
  EXPECT_EQ(sensorOf(against, "temp").greatest, 21);
}

TEST(AgainstLogs, AScienceRecordBelongsToTheNextTick) {
  LogBench bench;
  bench.dive({5, 5, 5, 5, 5});
  bench.science({1, 5, 6, 13}, {{"sci_water_temp", {15, 25, 24, 15}}});
  const AgainstLogs against = bench.run(watching("case temp > 20 degC goto b", "temp"));
  EXPECT_THAT(timesOf(against.cases.at(0)), ElementsAre(8));
  EXPECT_EQ(against.cases.at(0).firings.at(0).values.at(0).value, 24);  // the newest of the cycle
  EXPECT_EQ(against.cases.at(0).true_ticks, 2U);                        // 8 and 12 s
}

TEST(AgainstLogs, WithoutFlightRecordsTicksAreThoseOfScience) {
  LogBench bench;
  bench.science({0, 1, 2, 3}, {{"sci_water_temp", {15, 25, 24, 15}}});
  const AgainstLogs against = bench.run(watching("case temp > 20 degC goto b", "temp"));
  EXPECT_TRUE(against.science);
  EXPECT_EQ(against.ticks, 3U);
  EXPECT_THAT(timesOf(against.cases.at(0)), ElementsAre(1));
  EXPECT_TRUE(std::isnan(against.begin.depth_m));
  EXPECT_THAT(kindsOf(against), ElementsAre("start >a", "goto a>b"));  // it starts at once
}

/// The vehicle's own units: rad, degrees and minutes, bar.
TEST(AgainstLogs, ReadsTheVehiclesUnits) {
  LogBench bench;
  bench.dive({5, 5, 5}, {{"m_pitch", {0, -0.4537856055185257, 0}},
                         {"m_lat", {3900, 3910.5, 3900}},
                         {"m_pressure", {0, 2.5, 0}}});
  const AgainstLogs against = bench.run(watching(
      "case pitch < -20 deg && lat > 39.1 N && pressure > 20 dbar goto b", "pitch, lat, pressure"));
  const LoggedCase& one = against.cases.at(0);
  ASSERT_THAT(timesOf(one), ElementsAre(4));
  const auto& values = one.firings.at(0).values;
  ASSERT_EQ(values.size(), 3U);
  EXPECT_NEAR(values[0].value, -26, 1e-9);
  EXPECT_EQ(values[0].unit, "deg");
  EXPECT_NEAR(values[1].value, 39.175, 1e-9);
  EXPECT_EQ(values[1].unit, "deg");
  EXPECT_NEAR(values[2].value, 25, 1e-9);  // 2.5 bar, in the unit of the guard
  EXPECT_EQ(values[2].unit, "dbar");
}

/// D3: magnetic = true + variation, else the declination.
TEST(AgainstLogs, HeadingsAreFromTrueNorth) {
  const double degree = std::acos(-1) / 180;
  LogBench bench;
  bench.dive({5, 5, 5, 5}, {{"m_heading", {100 * degree, 100 * degree, 100 * degree, 5 * degree}},
                            {"m_gps_mag_var", {kNothing, kNothing, 10 * degree, kNothing}}});
  const AgainstLogs against =
      bench.run("declination 3 deg\n" + watching("case heading > 0 deg goto b", "heading"));
  const auto headings = [&](size_t i) { return against.cases.at(0).firings.at(i).values.at(0); };
  EXPECT_NEAR(headings(0).value, 103, 1e-9);  // variation -3 until the vehicle reports one
  EXPECT_NEAR(sensorOf(against, "heading").least, 90, 1e-9);
  EXPECT_NEAR(sensorOf(against, "heading").greatest, 355, 1e-9);
}

TEST(AgainstLogs, SaysWhyAGuardIsNeverKnown) {
  LogBench bench;
  bench.dive({5, 5, 5},
             {{"m_battery", {kNothing, kNothing, kNothing}}, {"m_altitude", {-5, 500, -1}}});
  const AgainstLogs against = bench.run(
      "extern function score(at: time): number in 0 .. 9\n" +
      watching("case battery < 11 V && chlorophyll > 2 goto b\n    case altitude < 3 m exit\n"
               "    case score(missiontime) > 3 exit",
               "missiontime, battery, chlorophyll, altitude"));
  EXPECT_THAT(against.cases.at(0).unknown_because,
              ElementsAre("`m_battery` was never updated",
                          "the data files do not contain `sci_flbbcd_chlor_units`"));
  EXPECT_THAT(against.cases.at(1).unknown_because,
              ElementsAre("`m_altitude` was updated 3 times, but never in its range at a tick"));
  EXPECT_THAT(against.cases.at(2).unknown_because, ElementsAre("`score` is a function in C"));
  EXPECT_THAT(against.without_code, ElementsAre("score"));
  EXPECT_EQ(against.cases.at(0).known_ticks, 0U);
}

/// A guard that was known is not called never known.
TEST(AgainstLogs, AGuardThatIsNeverTrueMayBeKnown) {
  LogBench bench;
  bench.dive({5, 5, 5});
  const AgainstLogs against = bench.run(watching("case depth > 10 m goto b", "depth"));
  EXPECT_EQ(against.cases.at(0).known_ticks, 2U);
  EXPECT_TRUE(against.cases.at(0).unknown_because.empty());
}

/// Three within 60 s; a fourth that is within 60 s of the second belongs to the same flicker.
TEST(AgainstLogs, FlickersAreThreeFiringsWithinAMinute) {
  const auto at = [](const std::vector<double>& seconds) {
    LogBench bench;
    std::vector<double> times = {0};
    std::vector<double> depths = {1};
    for (const double s : seconds) {
      times.insert(times.end(), {s, s + 1});
      depths.insert(depths.end(), {11, 1});
    }
    bench.flight(times, {{"m_depth", depths}});
    return bench.run(watching("case depth > 10 m goto b", "depth")).cases.at(0).flickers;
  };
  EXPECT_TRUE(at({10, 20}).empty());
  EXPECT_TRUE(at({10, 40, 71}).empty());
  const auto just = at({10, 40, 70});
  ASSERT_EQ(just.size(), 1U);
  EXPECT_EQ(just[0].first, 0U);
  EXPECT_EQ(just[0].count, 3U);
  EXPECT_EQ(just[0].seconds, 60);
  const auto two = at({10, 200, 220, 240, 270, 400, 410, 420});
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].first, 1U);
  EXPECT_EQ(two[0].count, 4U);
  EXPECT_EQ(two[0].seconds, 70);
  EXPECT_EQ(two[1].first, 5U);
  EXPECT_EQ(two[1].count, 3U);
}

/// Cases that leave the state do not fire, cases that stay do, also after one that would leave.
TEST(AgainstLogs, AStateIsHeldWhileItsGuardsAreEvaluated) {
  LogBench bench;
  bench.dive({1, 12, 12, 1, 12, 1, 12, 1, 12, 1});
  const AgainstLogs against =
      bench.run("var n: number = 0 in 0 .. 9\nvar left: number = 0 in 0 .. 9\n" +
                watching("case left > 0 exit\n    case n >= 3 goto b\n"
                         "    case became(depth > 10 m) do set n = min(n + 1, 9) end stay\n"
                         "    case depth > 11 m do set left = 1 end goto b\n"
                         "    case n >= 4 exit",
                         "depth"));
  EXPECT_THAT(timesOf(against.cases.at(2)), ElementsAre(4, 16, 24, 32));
  EXPECT_THAT(timesOf(against.cases.at(1)), ElementsAre(28));  // the tick after the third
  EXPECT_TRUE(against.cases.at(0).firings.empty());
  EXPECT_EQ(against.cases.at(1).firings.at(0).values.at(0).value, 3);
  EXPECT_THAT(timesOf(against.cases.at(4)), ElementsAre(36));
}

/// A state's parameters have the values of the first transition to it.
TEST(AgainstLogs, ParametersOfStatesComeFromTheFirstTransition) {
  LogBench bench;
  bench.dive({1, 8, 12, 16});
  const AgainstLogs against = bench.run(
      "state a\nbegin\n  flightprofile yo(3 m, 20 m, 26 deg, 26 deg)\n  sensors depth\n  events\n"
      "    case depth > 15 m goto b(7 m)\n    case depth > 14 m goto b(13 m)\nend\n"
      "state b(to: length)\nbegin\n  flightprofile yo(3 m, 20 m, 26 deg, 26 deg)\n"
      "  sensors depth\n  events\n    case depth > to exit\nend\n");
  const LoggedCase& one = against.cases.at(2);
  EXPECT_EQ(one.state, "b");
  EXPECT_THAT(timesOf(one), ElementsAre(4));
}

/// The values at a firing are those before its `do`.
TEST(AgainstLogs, ShowsWindowsAndVariables) {
  LogBench bench;
  bench.dive({1, 5, 12, 13}, {});
  const AgainstLogs against = bench.run(
      "var seen: length = 2 m\n" +
      watching("case highest(depth, 8 s) > seen + 9 m do set seen = depth end stay", "depth"));
  const LoggedCase& one = against.cases.at(0);
  ASSERT_THAT(timesOf(one), ElementsAre(8));
  const auto& values = one.firings.at(0).values;
  ASSERT_EQ(values.size(), 2U);
  EXPECT_EQ(values[0].name, "highest(depth, 8 s)");
  EXPECT_EQ(values[0].value, 12);
  EXPECT_EQ(values[1].name, "seen");
  EXPECT_EQ(values[1].value, 2);
}

TEST(AgainstLogs, LeavesOutTheCasesOfTheStandardLibrary) {
  LogBench bench;
  bench.dive({1, 5, 12});
  const AgainstLogs against = bench.run(
      "flightprofile mine(bottom: length)\nbegin\n  entry do descend(bottom, 26 deg) end\n  "
      "events\n"
      "    case depth > 10 m do ascend(3 m, 26 deg) end stay\nend\n"
      "always\n  case missiontime > 6 s exit\n"
      "state a\nbegin\n  flightprofile mine(20 m)\n  sensors missiontime, depth\nend\n");
  ASSERT_EQ(against.cases.size(), 2U);
  EXPECT_EQ(against.cases[0].list, "always");
  EXPECT_THAT(timesOf(against.cases[0]), ElementsAre(8));
  EXPECT_EQ(against.cases[1].list, "profile");
  EXPECT_EQ(against.cases[1].state, "a");
}

/// The mission starts below 2 m, its clock with it, and again at the next dive after its exit.
TEST(AgainstLogs, FollowsTheLogFromEachDive) {
  LogBench bench;
  bench.dive({1, 3, 8, 12, 8, 1, 5, 1, 3, 12});
  const AgainstLogs against = bench.run(
      watching("case depth > 10 m goto b\n    case missiontime >= 8 s && depth < 5 m exit",
               "missiontime, depth"));
  EXPECT_THAT(kindsOf(against),
              ElementsAre("start >a", "goto a>b", "exit b>", "start >a", "exit a>"));
  // Depths at 4 s intervals: 3 m starts it at 4 s, 12 m at 12 s, 1 m at 20 s; 5 m at 24 s …
  EXPECT_EQ(against.followed.at(0).at.time_s, LogBench::kBegin + 4);
  EXPECT_EQ(against.followed.at(1).at.time_s, LogBench::kBegin + 12);
  EXPECT_EQ(against.followed.at(2).at.time_s, LogBench::kBegin + 20);
  EXPECT_EQ(against.followed.at(3).at.time_s, LogBench::kBegin + 24);
  // … and 8 s later, at 32 s, it is at 3 m, where the mission ends. It starts again only after the
  // surface: the log ends below.
  EXPECT_EQ(against.followed.at(4).at.time_s, LogBench::kBegin + 32);
}

/// A case that stays is a step when it begins to fire, not on every tick.
TEST(AgainstLogs, AStayIsOneStepWhileItFires) {
  LogBench bench;
  bench.dive({3, 12, 13, 14, 8, 12});
  const AgainstLogs against = bench.run(
      "var n: number = 0 in 0 .. 9\n" +
      watching("case depth > 10 m do set n = 1 end stay\n    case n > 5 goto b", "depth"));
  EXPECT_THAT(kindsOf(against), ElementsAre("start >a", "stay a>a", "stay a>a"));
  EXPECT_EQ(against.followed.at(2).at.time_s, LogBench::kBegin + 20);
}

/// On a tick on which an earlier case that stays fires, a case does not; it does on the next one.
TEST(AgainstLogs, AnEarlierCaseFiresFirst) {
  LogBench bench;
  bench.dive({1, 12, 12, 1, 12, 1});
  const AgainstLogs against =
      bench.run("var n: number = 0 in 0 .. 9\n" +
                watching("case became(depth > 10 m) do set n = 1 end stay\n"
                         "    case depth > 10 m goto b\n    case n > 5 goto b",
                         "depth"));
  EXPECT_THAT(timesOf(against.cases.at(0)), ElementsAre(4, 16));
  EXPECT_THAT(timesOf(against.cases.at(1)), ElementsAre(8));
  EXPECT_EQ(against.cases.at(1).true_ticks, 3U);
  bench.dive({1, 12, 1});
  EXPECT_THAT(bench.textOf(bench.run(watching("case became(depth > 10 m) do log \"x\" end stay\n"
                                              "    case depth > 10 m goto b",
                                              "depth"))),
              HasSubstr("does not fire: true on 50 % of ticks, on each of which an earlier case"));
}

/// P3: after an outage of more than 300 s the mission does not continue.
TEST(AgainstLogs, AGapEndsTheMission) {
  const auto kinds = [](double gap_s, const std::string& limit) {
    LogBench bench;
    bench.flight({0, 4, 8, 8 + gap_s, 12 + gap_s}, {{"m_depth", {1, 5, 5, 5, 5}}});
    return kindsOf(bench.run(limit + watching("case depth > 10 m goto b", "depth")));
  };
  EXPECT_THAT(kinds(300, ""), ElementsAre("start >a"));
  EXPECT_THAT(kinds(301, ""), ElementsAre("start >a", "gap a>", "start >a"));
  EXPECT_THAT(kinds(301, "resume within 10 min\n"), ElementsAre("start >a"));
}

TEST(AgainstLogs, ShowsDistancesClocksAndTruthValues) {
  LogBench bench;
  bench.dive({1, 12, 12}, {{"m_lat", {3900, 3900, 3900}}, {"m_lon", {-7300, -7300, -7300}}});
  const AgainstLogs against = bench.run(
      "const place = 39 N 73 W\nvar seen: bool = false\n" +
      watching("case !seen && distance(place) < 0.5 km && statetime > 5 s do set seen = true end "
               "stay",
               "depth, lat, lon, statetime"));
  const auto& values = against.cases.at(0).firings.at(0).values;
  ASSERT_EQ(values.size(), 3U);
  EXPECT_EQ(values[0].name + " " + values[0].unit, "seen bool");
  EXPECT_EQ(values[0].value, 0);
  EXPECT_EQ(values[1].name + " " + values[1].unit, "distance(place) km");
  EXPECT_EQ(values[1].value, 0);
  EXPECT_EQ(values[2].name + " " + values[2].unit, "statetime s");
  EXPECT_EQ(values[2].value, 8);
  EXPECT_THAT(bench.textOf(against), HasSubstr("seen false, distance(place) 0 km, statetime 8 s"));
}

TEST(AgainstLogs, ReportsGaps) {
  LogBench bench;
  bench.flight({0, 4, 304, 605, 609}, {{"m_depth", {5, 5, 5, 5, 5}}});
  const AgainstLogs against = bench.run(watching("case depth > 10 m goto b", "depth"));
  EXPECT_EQ(against.gaps, 1U);  // 300 s is not longer than 300 s
  EXPECT_EQ(against.longest_gap_s, 301);
}

/// What the mission sets when it leaves a state is not set for a guard that is tried alone.
TEST(AgainstLogs, AGuardThatIsOnlyTrueAfterATransitionIsNotCalledNeverTrue) {
  LogBench bench;
  bench.dive({3, 5, 11, 12, 13, 14, 15, 3});
  const std::string mission =
      "var ready : number = 0 in 0 .. 1\n"
      "state a\nbegin\n  flightprofile yo(3 m, 20 m, 26 deg, 26 deg)\n  sensors depth\n  events\n"
      "    case depth > 10 m do set ready = 1 end goto b\nend\n"
      "state b\nbegin\n  flightprofile yo(3 m, 20 m, 26 deg, 26 deg)\n  sensors depth\n  events\n"
      "    case ready == 1 && depth > 12.5 m goto c\n    case depth > 100 m goto c\nend\n"
      "state c\nbegin\n  flightprofile surfaced\n  sensors depth\n  events\n"
      "    case depth < 4 m exit\nend\n";
  const AgainstLogs against = bench.run(mission);
  ASSERT_EQ(kindsOf(against).size(), 4U);
  EXPECT_EQ(kindsOf(against)[2], "goto b>c");
  const LoggedCase& late = against.cases.at(1);
  EXPECT_EQ(late.true_ticks, 0U);
  EXPECT_EQ(late.followed_true_ticks, 1U) << "it leaves";
  EXPECT_EQ(against.cases.at(0).followed_true_ticks, 1U);
  EXPECT_EQ(against.cases.at(2).followed_true_ticks, 0U);
  const std::string text = bench.textOf(against);
  EXPECT_THAT(text,
              HasSubstr("      never true, known on 100 % of ticks\n"
                        "      but true on 1 tick of what the mission would have done, below\n"
                        "    line"));
  EXPECT_EQ(text.find("but true"), text.rfind("but true"));
}

TEST(AgainstLogs, TheTextSaysWhatAPilotNeeds) {
  LogBench bench;
  bench.dive({1, 5, 11, 12, 13, 8, 11, 3});
  const std::string text = bench.textOf(bench.run(
      watching("case depth > 10 m goto b\n    case oxygen > 3 goto b\n    case depth > 50 m exit",
               "depth, oxygen")));
  EXPECT_THAT(text, HasSubstr("2024-07-02 18:55:27 to 2024-07-02 18:55:55 UTC"));
  EXPECT_THAT(text, HasSubstr("line 7: depth > 10 m → goto b\n"
                              "      fires twice, true on 57 % of ticks, known on 100 % of ticks\n"
                              "        first  2024-07-02 18:55:35 (0.00 h)  depth 11.0 m\n"));
  EXPECT_THAT(text, HasSubstr("never known: the data files do not contain"));
  EXPECT_THAT(text, HasSubstr("never true, known on 100 % of ticks"));
  EXPECT_THAT(text, HasSubstr("the vehicle did not obey it"));
  EXPECT_THAT(text, HasSubstr("a → b (goto), line 7: depth 11.0 m"));
}

/// A real glider: 21 dives through a thermocline at 12 to 18 m. The numbers were counted in the CSV
/// of `glidercc log` by a script of a few lines.
TEST(AgainstRealLogs, FireOnEachDive) {
  const std::filesystem::path folder =
      std::filesystem::path(GLIDER_SOURCE_DIR) / "../shared/data/dbd";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "the real data files are not here: " << folder;
  }
  LogBench bench;
  const AgainstLogs against =
      bench.runAlong(watching("case depth > 30 m goto b\n    case temp < 17 degC goto b\n"
                              "    case spread(temp, 10 m of depth) >= 1.5 degC goto b",
                              "depth, temp"),
                     {folder / "comet-2019-218-00-034.dbd", folder / "comet-2019-218-00-034.ebd"},
                     {folder / "cac"});
  EXPECT_EQ(against.vehicle, "comet");
  EXPECT_EQ(against.ticks, 2359U);
  const LoggedCase& deep = against.cases.at(0);
  ASSERT_EQ(deep.firings.size(), 21U);
  EXPECT_NEAR(deep.firings[0].at.time_s, 1565364619.6, 0.1);
  EXPECT_NEAR(deep.firings[0].at.depth_m, 30.3923, 1e-4);
  EXPECT_EQ(against.cases.at(1).firings.size(), 21U);
  // Through the layer on each leg, down and up.
  const LoggedCase& layer = against.cases.at(2);
  EXPECT_EQ(layer.firings.size(), 42U);
  for (const LoggedFiring& firing : layer.firings) {
    EXPECT_GT(firing.at.depth_m, 8);
    EXPECT_LT(firing.at.depth_m, 20);
  }
}

}  // namespace
}  // namespace glider::analysis
