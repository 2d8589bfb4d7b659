// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Every mission of the gallery is fine, builds for every board, and does in its world what it is
// for.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <set>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

struct GalleryFlight {
  const char* mission;
  const char* scenario;
  const char* shows;  ///< text in the summary of the flight
};

const GalleryFlight kFlights[] = {
    {"avoid_ground", "shelf_slope", "transect → rise (call, always case 1)"},
    {"bloom", "bloom", "sample → transect (return)"},
    {"bottom_following", "shelf_slope", "follow → end (exit)"},
    {"front", "front", "back → across (goto)"},
    {"hull_sweep", "default", "map → end (exit)  routedone"},
    {"isotherms", "default", "sample → end (exit)"},
    {"low_battery", "low_battery", "survey → give_back (goto, always case 1)"},
    {"surface_on_event", "default", "strong layer"},
    {"survey_box", "default", "leg, metres to go 4"},
    {"thermocline", "figure5", "the mission has ended normally"},
    {"virtual_mooring", "default", "keep → end (exit)"},
    {"water_column", "default", "stop → up (goto)"},
    {"within_budget", "default", "back → end (exit)"},
    {"way_points", "default", "sail → end (exit)  routedone"},
};

std::string pathOf(const std::string& mission) {
  return GLIDER_SOURCE_DIR "/missions/gallery/" + mission + ".mission";
}

class Gallery : public testing::TestWithParam<GalleryFlight> {};

TEST_P(Gallery, IsFineBuildsAndFlies) {
  const std::string path = pathOf(GetParam().mission);
  const TemporaryFolder folder;
  const std::string to = " -o " + (folder.path() / "product").string();
  const Outcome checked = runShell("$GLIDERCC check " + path);
  EXPECT_EQ(checked.status, 0);
  EXPECT_EQ(checked.err, "");
  for (const char* board : {"host", "ts7800", "ts5500", "pizero2", "cm4"}) {
    const Outcome built = runShell("$GLIDERCC build " + path + " --target " + board + to);
    EXPECT_EQ(built.status, 0) << board << ": " << built.err;
  }
  const Outcome flown =
      runShell("$GLIDERCC sim " + path + " --scenario " + GetParam().scenario + to + ".flight");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr(GetParam().shows));
  EXPECT_THAT(flown.out, Not(HasSubstr("refused")));
}

INSTANTIATE_TEST_SUITE_P(Missions, Gallery, testing::ValuesIn(kFlights),
                         [](const auto& tested) { return std::string(tested.param.mission); });

/// A mooring that trusts its reckoning drifts away with it.
TEST(GalleryFlights, TheVirtualMooringStaysWhereItIsInTruth) {
  const Flight flight = fly(pathOf("virtual_mooring") + " --scenario default");
  const auto east = flight.column("true_x"), north = flight.column("true_y");
  double furthest = 0;
  for (size_t i = 0; i < east.size(); ++i) {
    furthest = std::fmax(furthest, std::hypot(east[i], north[i]));
  }
  EXPECT_GT(furthest, 300) << "it drifts at all";
  // The watch circle of 400 m, and what an hour's reckoning does not see of a current of 0.036 m/s.
  EXPECT_LT(furthest, 530) << "and comes back";
}

TEST(GalleryFlights, TheFrontIsCrossedAgainAndAgain) {
  const Flight flight = fly(pathOf("front") + " --scenario front");
  EXPECT_GE(flight.transitions().size(), 9U);
}

TEST(GalleryFlights, DivesEndNearTheBottomButNotOnIt) {
  for (const char* mission : {"bottom_following", "avoid_ground"}) {
    const Flight flight = fly(pathOf(mission) + " --scenario shelf_slope");
    const auto depth = flight.column("true_depth"), bottom = flight.column("water_depth");
    double nearest = 1000;
    for (size_t i = 0; i < depth.size(); ++i) {
      nearest = std::fmin(nearest, bottom[i] - depth[i]);
    }
    EXPECT_GT(nearest, 4) << mission;
    EXPECT_LT(nearest, 9) << mission;
  }
}

TEST(GalleryList, HasEveryMission) {
  std::set<std::string> listed;
  for (const GalleryFlight& flight : kFlights) {
    listed.insert(flight.mission);
  }
  std::set<std::string> there;
  for (const auto& entry :
       std::filesystem::directory_iterator(GLIDER_SOURCE_DIR "/missions/gallery")) {
    there.insert(entry.path().stem().string());
  }
  EXPECT_EQ(listed, there);
}

}  // namespace
}  // namespace glider::tests
