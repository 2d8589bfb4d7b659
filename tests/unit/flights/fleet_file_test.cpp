// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a fleet file says, and what is refused in one.

#include "flights/fleet/fleet_file.h"

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::flights {
namespace {

using testing::HasSubstr;

support::Result<Fleet> load(const std::string& text) {
  const tests::TemporaryFolder folder;
  return loadFleet(folder.write("f.toml", text));
}

/// Why the file is refused; "accepted" if it is not.
std::string refusal(const std::string& text) {
  const auto fleet = load(text);
  return fleet ? "accepted" : fleet.error().message;
}

const std::string kOne = "[[vehicle]]\nname = \"a\"\nmission = \"a.mission\"\n";

TEST(FleetFile, SaysWhatFliesWhere) {
  const tests::TemporaryFolder folder;
  const auto fleet = loadFleet(folder.write("loop.toml", R"(
scenario = "sea/front.toml"
seed = 7
duration_s = 3600
separation_m = 200

[[vehicle]]
name = "north"
mission = "missions/loop.mission"
bearing_deg = 90
distance_m = 1500
set = ["corner = 39.1 N 73.8 W"]
link = ["own.o"]

[[vehicle]]
name = "south-2"
mission = "b.mission"
latitude_deg = 39
longitude_deg = -73.5
heading_deg = 180
mi = "own.mi"
)"));
  ASSERT_TRUE(fleet.has_value()) << fleet.error().message;
  EXPECT_EQ(fleet->name, "loop");
  EXPECT_EQ(fleet->scenario, (folder.path() / "sea/front.toml").string());
  EXPECT_EQ(fleet->seed, 7U);
  EXPECT_EQ(fleet->duration_s, 3600);
  EXPECT_EQ(fleet->separation_m, 200);
  ASSERT_EQ(fleet->vehicles.size(), 2U);
  const FleetVehicle& north = fleet->vehicles[0];
  EXPECT_EQ(north.mission, folder.path() / "missions/loop.mission");
  ASSERT_TRUE(north.offset.has_value());
  EXPECT_NEAR(north.offset->east_m, 1500, 1e-9);
  EXPECT_NEAR(north.offset->north_m, 0, 1e-9);
  EXPECT_EQ(north.settings, std::vector<std::string>{"corner = 39.1 N 73.8 W"});
  EXPECT_EQ(north.user_code, std::vector<std::string>{(folder.path() / "own.o").string()});
  const FleetVehicle& south = fleet->vehicles[1];
  EXPECT_EQ(south.place, (simulator::GeoPosition{39, -73.5}));
  EXPECT_EQ(south.heading_deg, 180);
  EXPECT_EQ(south.mi, folder.path() / "own.mi");
}

TEST(FleetFile, NeedsNothingButNamesAndMissions) {
  const auto fleet = load(kOne);
  ASSERT_TRUE(fleet.has_value()) << fleet.error().message;
  EXPECT_EQ(fleet->scenario, "default");
  EXPECT_FALSE(fleet->seed.has_value());
  EXPECT_FALSE(fleet->separation_m.has_value());
  EXPECT_FALSE(fleet->vehicles[0].offset.has_value());
  EXPECT_FALSE(fleet->vehicles[0].place.has_value());
}

TEST(FleetFile, RefusesEachMistakeWithItsLine) {
  const struct {
    std::string text, why;
  } kMistakes[] = {
      {"", "f.toml:1: `vehicle` of the fleet file must be one or more tables"},
      {"vehicle = []\n", "must be one or more tables"},
      {"vehicle = 3\n", "must be one or more tables"},
      {kOne + kOne, "f.toml:5: `name` of [[vehicle]] is that of another vehicle too: `a`"},
      {"sea = \"x\"\n" + kOne, "f.toml:1: the fleet file has an unknown key `sea`"},
      {"seed = -1\n" + kOne, "f.toml:1: `seed` of the fleet file must not be negative"},
      {"duration_s = 0\n" + kOne, "must be from 1 to"},
      {"separation_m = 0\n" + kOne, "`separation_m` of the fleet file must be from 1 to 100000"},
      {"[[vehicle]]\nmission = \"a.mission\"\n", "[[vehicle]] has no `name`"},
      {"[[vehicle]]\nname = \"a\"\n", "[[vehicle]] has no `mission`"},
      {"[[vehicle]]\nname = \"a/b\"\nmission = \"m\"\n", "must be of letters, digits"},
      {"[[vehicle]]\nname = \"..\"\nmission = \"m\"\n", "must be of letters, digits"},
      {"[[vehicle]]\nname = \"\"\nmission = \"m\"\n", "must be of letters, digits"},
      {kOne + "latitude_deg = 39\n", "`latitude_deg` of [[vehicle]] needs `longitude_deg`"},
      {kOne + "distance_m = 39\n", "`distance_m` of [[vehicle]] needs `bearing_deg`"},
      {kOne + "latitude_deg = 90\nlongitude_deg = 0\n", "must be from -89 to 89"},
      {kOne + "bearing_deg = 361\ndistance_m = 1\n", "must be from 0 to 360"},
      {kOne + "latitude_deg = 1\nlongitude_deg = 0\nbearing_deg = 3\ndistance_m = 1\n",
       "a vehicle has one start"},
      {kOne + "set = \"a = 3\"\n", "`set`"},
      {"[[vehicle]\n", "f.toml:1"},
  };
  for (const auto& mistake : kMistakes) {
    EXPECT_THAT(refusal(mistake.text), HasSubstr(mistake.why)) << mistake.text;
  }
}

TEST(FleetFile, GivesEachModemAnAddress) {
  const auto of = [](const std::string& one, const std::string& other) {
    return kOne + one + "[[vehicle]]\nname = \"b\"\nmission = \"b.mission\"\n" + other;
  };
  const auto counted = load(of("", ""));
  ASSERT_TRUE(counted.has_value());
  EXPECT_EQ(counted->vehicles[0].address, 1U);
  EXPECT_EQ(counted->vehicles[1].address, 2U);
  EXPECT_EQ(slotsOf(*counted), 2U);
  const auto given = load(of("address = 7\n", "address = 3\n"));
  ASSERT_TRUE(given.has_value());
  EXPECT_EQ(given->vehicles[0].address, 7U);
  EXPECT_EQ(slotsOf(*given), 7U) << "a slot that no vehicle has stays empty";
  EXPECT_THAT(refusal(of("address = 3\n", "address = 3\n")),
              HasSubstr("3 is that of `a` too: two vehicles would send at the same time"));
  EXPECT_THAT(refusal(of("address = 3\n", "")), HasSubstr("missing for `b`"));
  EXPECT_THAT(refusal(of("", "address = 3\n")), HasSubstr("missing for `a`"));
  for (const char* wrong : {"0", "16", "-1", "1.5"}) {
    EXPECT_THAT(refusal(of(std::string("address = ") + wrong + "\n", "")), HasSubstr("address"))
        << wrong;
  }
}

TEST(FleetFile, HasAtMostAHundredVehicles) {
  std::string text;
  for (int i = 0; i < 101; ++i) {
    text += "[[vehicle]]\nname = \"v" + std::to_string(i) + "\"\nmission = \"m\"\n";
  }
  EXPECT_THAT(refusal(text), HasSubstr("has 101 vehicles; a fleet has at most 100"));
}

TEST(FleetFile, IsKnownByItsName) {
  EXPECT_TRUE(isFleetFile("a/loop.toml"));
  EXPECT_FALSE(isFleetFile("loop.mission"));
  EXPECT_FALSE(isFleetFile("toml"));
}

}  // namespace
}  // namespace glider::flights
