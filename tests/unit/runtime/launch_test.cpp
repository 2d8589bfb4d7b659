// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Parameters at launch: what a pilot writes, and what the mission allows.

#include "runtime/launch/launch.h"

#include "tests/unit/runtime/bench_mission.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

namespace glider::runtime::testing {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr const char* kTime =
    "s=3ff0000000000000 min=404e000000000000 h=40ac200000000000 day=40f5180000000000";
constexpr const char* kLength = "m=3ff0000000000000 cm=3f847ae147ae147b km=408f400000000000";

class LaunchTest : public ::testing::Test {
 protected:
  LaunchTest() {
    bench_.states = {benchState("a")};
    bench_.parameters = {
        {"bottom", 25, 10, 30, kLength},
        {"survey.top", 5, 1, kEndless, kLength},
        {"deep", 0, 0, 1, "bool"},
        {"lat", 39, -90, 90, "N=3ff0000000000000 S=bff0000000000000"},
        {"lon", -73.5, -180, 180, "E=3ff0000000000000 W=bff0000000000000"},
        {"gain", 0.5, -kEndless, kEndless, "=3ff0000000000000 %=3f847ae147ae147b"},
        {"home.latitude", 39, -90, 90, "N=3ff0000000000000 S=bff0000000000000"},
        {"home.longitude", -73.5, -180, 180, "E=3ff0000000000000 W=bff0000000000000"},
        {"far.latitude", 0, -90, 90, "N=3ff0000000000000 S=bff0000000000000"},
        {"lasts", 60, 0, kEndless, kTime}};
    bench_.condition = [](const GliderContext& c) {
      return c.variables[0] >= c.variables[1] + 5 ? GLIDER_NO_CASE : 0U;
    };
    bench_.finish(0);
  }
  /// The problem with a setting; empty if there is none.
  static std::string set(Launch& launch, const std::string& setting) {
    return launch.set({setting.data(), setting.data() + setting.size()}) ? "" : launch.problem();
  }
  BenchMission bench_;
};

/// A time whose default is of the calendar is set and shown as one.
TEST(LaunchDates, AreReadAndWrittenAsInMissions) {
  const GliderParameterInfo begins{"begins", 1803859200, 946684800, 4102444800, kTime};
  GliderMission mission{};
  mission.parameter_count = 1;
  mission.parameters = &begins;
  Launch launch(mission);
  const auto set = [&](const std::string& value) {
    const std::string setting = "begins = " + value;
    return launch.set({setting.data(), setting.data() + setting.size()}) ? "" : launch.problem();
  };
  const auto written = [&](double value) {
    char bytes[60];
    Text text(bytes, sizeof bytes);
    writeQuantity(begins, value, text);
    return std::string(bytes, text.size());
  };
  const std::pair<const char*, double> kTable[] = {{"2027-03-01T00:00Z", 1803859200},
                                                   {"2000-01-01T00:00Z", 946684800},
                                                   {"2028-02-29T23:59:59Z", 1835481599},
                                                   {"2099-12-31T12:30Z", 4102403400}};
  for (const auto& [text, seconds] : kTable) {
    EXPECT_STREQ(set(text), "") << text;
    EXPECT_EQ(launch.values()[0], seconds) << text;
    EXPECT_EQ(written(seconds), text);
  }
  EXPECT_STREQ(set("1803859200"), "");
  EXPECT_EQ(launch.values()[0], 1803859200);
  for (const char* wrong : {"2027-02-29T00:00Z", "2027-13-01T00:00Z", "2027-03-01T24:00Z",
                            "2027-03-01 00:00Z", "2027-03-01T00:00", "27-03-01T00:00Z", "soon"}) {
    EXPECT_EQ(set(wrong), "`begins` cannot be `" + std::string(wrong) +
                              "`: write a time such as `2027-03-01T00:00Z`, or seconds since 1970");
  }
  EXPECT_STREQ(set("1999-12-31T00:00Z"),
               "`begins` cannot be `1999-12-31T00:00Z`: outside its range, 2000-01-01T00:00Z to "
               "2100-01-01T00:00Z");
}

TEST_F(LaunchTest, TakesValuesWithTheirUnits) {
  Launch launch(bench_.mission);
  EXPECT_EQ(launch.values()[0], 25);
  const struct {
    const char* setting;
    int parameter;
    double value;
  } table[] = {{"bottom=20", 0, 20},
               {"bottom = 20 m", 0, 20},
               {"bottom=2000cm", 0, 20},
               {" bottom =\t.02 km ", 0, 20},
               {"bottom=1.25e1m", 0, 12.5},
               {"survey.top=+3.", 1, 3},
               {"deep=true", 2, 1},
               {"deep = false", 2, 0},
               {"lat=39.2 S", 3, -39.2},
               {"lat=39.175N", 3, 39.175},
               {"lat=39 10.5 N", 3, 39 + 10.5 / 60},
               {"lat= 39\t10.5S ", 3, -(39 + 10.5 / 60)},
               {"lat=39 .5 N", 3, 39 + .5 / 60},
               {"lat=3910.5 N", 3, 39 + 10.5 / 60},
               {"lat=0039.1 S", 3, -39.1 / 60},
               {"lon=139.5 E", 4, 139.5},
               {"lon=13930 E", 4, 139.5},
               {"lon=73 49.8058 W", 4, -(73 + 49.8058 / 60)},
               {"lat=3910.5", 3, 39 + 10.5 / 60},
               {"lat=-3910.1234567", 3, -(39 + 10.1234567 / 60)},
               {"lat=0039.1", 3, 39.1 / 60},
               {"lat=0", 3, 0},
               {"lat=9000", 3, 90},
               {"lon=-7349.8058", 4, -(73 + 49.8058 / 60)},
               {"lon=73.83 W", 4, -73.83},
               {"lon=180 E", 4, 180},
               {"lasts=3 h 30 min", 9, 12600},
               {"lasts=1day6h 1 min30 s", 9, 108090},
               {"lasts=1e3 s", 9, 1000},
               {"lasts=90", 9, 90},
               {"gain=-20%", 5, -0.2},
               {"gain=0.1", 5, 0.1},
               {"gain=-0", 5, 0},
               {"gain=1e22", 5, 1e22},
               {"gain=25e-2", 5, 0.25},
               {"gain=2.5E-1", 5, 0.25},
               {"gain=25e+2", 5, 2500},
               {"gain=5e-22", 5, 5e-22},
               {"gain=123456789.012345", 5, 123456789.012345},
               {"gain=000000000000000000.5", 5, 0.5}};
  for (const auto& row : table) {
    EXPECT_EQ(set(launch, row.setting), "") << row.setting;
    EXPECT_NEAR(launch.values()[row.parameter], row.value, std::fabs(row.value) * 1e-15)
        << row.setting;
  }
}

TEST_F(LaunchTest, SaysWhatIsWrongAndChangesNothing) {
  Launch launch(bench_.mission);
  const std::pair<const char*, const char*> table[] = {
      {"botom=20m",
       "the mission has no parameter `botom`; it has bottom, survey.top, deep, lat, lon, gain, "
       "home, far.latitude, lasts"},
      {"bottom", "`bottom` sets nothing; write `name=value`"},
      {"", "`` sets nothing; write `name=value`"},
      {"bottom=40m", "`bottom` cannot be `40m`: outside its range, 10 m to 30 m"},
      {"survey.top=0", "`survey.top` cannot be `0`: outside its range, at least 1 m"},
      {"bottom=20 kg", "`bottom` cannot be `20 kg`: write a value with a unit: m, cm, km"},
      {"lasts=30 min 3 h",
       "`lasts` cannot be `30 min 3 h`: write a value with a unit: s, min, h, day"},
      {"lasts=1 h 70 min",
       "`lasts` cannot be `1 h 70 min`: write a value with a unit: s, min, h, day"},
      {"lasts=1 h 30", "`lasts` cannot be `1 h 30`: write a value with a unit: s, min, h, day"},
      {"lasts=-1 h 30 min",
       "`lasts` cannot be `-1 h 30 min`: write a value with a unit: s, min, h, day"},
      {"bottom=20 m m", "`bottom` cannot be `20 m m`: write a value with a unit: m, cm, km"},
      {"bottom=", "`bottom` cannot be ``: it is not a number"},
      {"bottom=m", "`bottom` cannot be `m`: it is not a number"},
      {"bottom=nan", "`bottom` cannot be `nan`: it is not a number"},
      {"bottom=.", "`bottom` cannot be `.`: it is not a number"},
      {"bottom=1e", "`bottom` cannot be `1e`: write a value with a unit: m, cm, km"},
      {"gain=1.234567890123456",
       "`gain` cannot be `1.234567890123456`: more than 15 digits, or too large or small"},
      {"gain=1e23", "`gain` cannot be `1e23`: more than 15 digits, or too large or small"},
      {"gain=1e-23", "`gain` cannot be `1e-23`: more than 15 digits, or too large or small"},
      {"gain=1e99999999999",
       "`gain` cannot be `1e99999999999`: more than 15 digits, or too large or small"},
      {"lat=39.2", "`lat` cannot be `39.2`: write a value with a unit: N, S, or ddmm.mmmm"},
      {"lat=-39.2 N", "`lat` cannot be `-39.2 N`: write a minus sign or a letter, not both"},
      {"lat=73.8 W", "`lat` cannot be `73.8 W`: write a value with a unit: N, S, or ddmm.mmmm"},
      {"lat=3960", "`lat` cannot be `3960`: a degree has only 60 minutes"},
      {"lat=39,175 N", "`lat` cannot be `39,175 N`: write a value with a unit: N, S, or ddmm.mmmm"},
      {"lat=39 60 N", "`lat` cannot be `39 60 N`: a degree has only 60 minutes"},
      {"lat=39.5 10 N",
       "`lat` cannot be `39.5 10 N`: write a value with a unit: N, S, or ddmm.mmmm"},
      {"lat=-39 10 N", "`lat` cannot be `-39 10 N`: write a minus sign or a letter, not both"},
      {"lat=39 -10 N", "`lat` cannot be `39 -10 N`: write a value with a unit: N, S, or ddmm.mmmm"},
      {"lat=39 10", "`lat` cannot be `39 10`: write a value with a unit: N, S, or ddmm.mmmm"},
      {"lat=39 10 20 N",
       "`lat` cannot be `39 10 20 N`: write a value with a unit: N, S, or ddmm.mmmm"},
      {"lat=3960 N", "`lat` cannot be `3960 N`: a degree has only 60 minutes"},
      {"lat=90 30 N", "`lat` cannot be `90 30 N`: outside its range, 90 S to 90 N"},
      {"lat=39 1e-30 N",
       "`lat` cannot be `39 1e-30 N`: more than 15 digits, or too large or small"},
      {"lat=91 N", "`lat` cannot be `91 N`: outside its range, 90 S to 90 N"},
      {"lat=9000.1", "`lat` cannot be `9000.1`: outside its range, 90 S to 90 N"},
      {"lat=-18000", "`lat` cannot be `-18000`: outside its range, 90 S to 90 N"},
      {"lon=-73.8", "`lon` cannot be `-73.8`: write a value with a unit: E, W, or ddmm.mmmm"},
      {"lon=18000.5", "`lon` cannot be `18000.5`: outside its range, 180 W to 180 E"},
      {"lon=181 W", "`lon` cannot be `181 W`: outside its range, 180 W to 180 E"},
      {"deep=1", "`deep` cannot be `1`: write `true` or `false`"}};
  for (const auto& [setting, problem] : table) {
    EXPECT_EQ(set(launch, setting), problem);
    EXPECT_EQ(launch.values()[0], 25);
  }
}

TEST_F(LaunchTest, TakesAPositionAsTheLanguageWritesIt) {
  const std::pair<const char*, std::pair<double, double>> table[] = {
      {"home=39.175 N 73.83 W", {39.175, -73.83}},
      {" home = 39 10.5 N 73 49.8 W ", {39 + 10.5 / 60, -(73 + 49.8 / 60)}},
      {"home=3910.5 N 7349.8 W", {39 + 10.5 / 60, -(73 + 49.8 / 60)}},
      {"home=3910.5S\t17349.8E", {-(39 + 10.5 / 60), 173 + 49.8 / 60}},
      {"home=39.175 S 73 49.8 W", {-39.175, -(73 + 49.8 / 60)}},
      {"home=0 N 0 W", {0, 0}},
      {"home=90 S 180 E", {-90, 180}}};
  for (const auto& [setting, values] : table) {
    Launch launch(bench_.mission);
    EXPECT_EQ(set(launch, setting), "") << setting;
    EXPECT_NEAR(launch.values()[6], values.first, 1e-13) << setting;
    EXPECT_NEAR(launch.values()[7], values.second, 1e-13) << setting;
  }
}

/// Of two settings the later one counts, also where one is of a half.
TEST_F(LaunchTest, AHalfOfAPositionMayBeSetAlone) {
  Launch launch(bench_.mission);
  EXPECT_EQ(set(launch, "home.longitude = 10 E"), "");
  EXPECT_EQ(set(launch, "home = 39 N 74 W"), "");
  EXPECT_EQ(set(launch, "home.latitude = 40 N"), "");
  EXPECT_EQ(launch.values()[6], 40);
  EXPECT_EQ(launch.values()[7], -74);
}

TEST_F(LaunchTest, SaysWhatIsWrongWithAPosition) {
  Launch launch(bench_.mission);
  const std::pair<const char*, const char*> table[] = {
      {"39.175 N", ": the longitude is missing"},
      {"73.83 W", ": the latitude comes first"},
      {"73.83 W 39.175 N", ": the latitude comes first"},
      {"39.175 N, 73.83 W", ": write no comma"},
      {"3910.5 -7349.8", ": write it with letters"},
      {"39.175 73.83", ": write it with letters"},
      {"", ": write it with letters"},
      {"39.175 N 73.83", ": the longitude needs its letter, E or W"},
      {"39.175 N -7349.8", ": the longitude needs its letter, E or W"},
      {"39.175 N 40 S", ": the longitude needs its letter, E or W"},
      {"91 N 73.83 W", ": latitudes are from 90 S to 90 N"},
      {"39.175 N 181 W", ": longitudes are from 180 W to 180 E"},
      {"39 60 N 73 W", ": a degree has only 60 minutes"},
      {"3910.5 N 7360 W", ": a degree has only 60 minutes"},
      {"-39.175 N 73.83 W", ": write a minus sign or a letter, not both"},
      {"39.175 N -73.83 W", ": write a minus sign or a letter, not both"},
      {"39.1234567890123456 N 73 W", ": more than 15 digits, or too large or small"},
      {"N W", ""},
      {"39,175 N 73,83 W", ""},
      {"39.175 N 73.83 W 5 W", ""},
      {"39.175 N north W", ""}};
  for (const auto& [value, why] : table) {
    EXPECT_EQ(set(launch, std::string("home=") + value),
              std::string("`home` cannot be `") + value + "`" + why +
                  "; a position is written `39.175 N 73.83 W`, `39 10.5 N 73 49.8 W` or "
                  "`3910.5 N 7349.8 W`");
    EXPECT_EQ(launch.values()[6], 39);
    EXPECT_EQ(launch.values()[7], -73.5);
  }
  EXPECT_NE(set(launch, "far=39 N 73 W"), "") << "it is not a position";
  EXPECT_NE(set(launch, "=39 N 73 W"), "");
}

TEST_F(LaunchTest, APilotsNovelIsCutShort) {
  Launch launch(bench_.mission);
  const std::string problem = set(launch, std::string(100000, 'x') + "=1");
  EXPECT_LT(problem.size(), 401U);
  EXPECT_NE(problem.find("no parameter `xxx"), std::string::npos);
}

TEST_F(LaunchTest, ReadsAFile) {
  Launch launch(bench_.mission);
  auto all = [&](const std::string& text) {
    return launch.setAll("dive.txt", {text.data(), text.data() + text.size()}) ? ""
                                                                               : launch.problem();
  };
  EXPECT_STREQ(all("# a comment\r\n\n  bottom = 20 m # not 25\r\nsurvey.top=2"), "");
  EXPECT_EQ(launch.values()[0], 20);
  EXPECT_EQ(launch.values()[1], 2);
  EXPECT_STREQ(all(""), "");
  EXPECT_STREQ(all("\n\nbottom = 7\n"),
               "dive.txt:3: `bottom` cannot be `7`: outside its range, 10 m to 30 m");
  EXPECT_STREQ(all(std::string("bottom = 12\0m", 13).c_str()), "");
}

TEST_F(LaunchTest, ParametersMustFitTogether) {
  Launch launch(bench_.mission);
  EXPECT_TRUE(launch.check());
  EXPECT_EQ(set(launch, "survey.top = 21 m"), "");
  EXPECT_FALSE(launch.check());
  EXPECT_STREQ(launch.problem(), "the parameters do not satisfy `where` number 1");
}

TEST_F(LaunchTest, AMissionWithoutParametersIsReported) {
  BenchMission bench;
  bench.states = {benchState("a")};
  bench.finish(0);
  Launch launch(bench.mission);
  EXPECT_TRUE(launch.check());
  EXPECT_EQ(set(launch, "bottom=2"), "the mission has no parameter `bottom`; it has none");
}

}  // namespace
}  // namespace glider::runtime::testing
