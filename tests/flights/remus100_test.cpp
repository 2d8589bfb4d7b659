// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions for a REMUS 100, which is steered by RECON, with the command.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using testing::HasSubstr;

class Remus100 : public testing::Test {
 protected:
  /// A mission of two states for a vehicle; it names neither pitch nor speed.
  [[nodiscard]] std::string survey(const std::string& platform) const {
    return folder_
        .write("survey_" + platform + ".mission",
               "mission survey\nplatform " + platform +
                   "\nrequire always depth <= 30 m\nstate down\nbegin\n"
                   "  flightprofile yo(5 m, 20 m)\n"
                   "  flightroute heading(90 deg)\n  sensors missiontime, depth\n  events\n"
                   "    case missiontime >= 5 min goto back\nend\n"
                   "state back\nbegin\n  flightprofile yo(3 m, 12 m)\n"
                   "  flightroute heading(270 deg)\n  sensors missiontime, depth\n  events\n"
                   "    case missiontime >= 10 min exit\nend\n")
        .string();
  }
  const TemporaryFolder folder_;
};

/// The transitions of a flight and why, without their times.
std::vector<std::string> happenings(const Flight& flight) {
  std::vector<std::string> all;
  for (const Event& event : flight.transitions()) {
    all.push_back(event.what + " " + event.why);
  }
  return all;
}

TEST_F(Remus100, FliesTheSameInProcessAndOnBoards) {
  const std::string mission = survey("remus100");
  const Flight here = fly(mission);
  ASSERT_EQ(here.outcome.status, 0) << here.outcome.err;
  const auto depth = here.column("true_depth");
  EXPECT_GT(*std::ranges::max_element(depth), 19.5);
  EXPECT_LT(*std::ranges::max_element(depth), 23);
  EXPECT_EQ(here.transitions().size(), 2U);
  EXPECT_EQ(std::ranges::count_if(here.events,
                                  [](const Event& event) {
                                    return event.what.find(
                                               "the override has ended: released by "
                                               "the SBC") != std::string::npos;
                                  }),
            1);
  for (const char* board : {"host", "ts7800", "ts5500"}) {
    const Flight there = fly(mission + " --board " + board);
    EXPECT_EQ(there.outcome.status, 0) << there.outcome.err;
    EXPECT_TRUE(there.csv == here.csv) << board;
    EXPECT_EQ(happenings(there), happenings(here)) << board;
  }
}

TEST_F(Remus100, WithoutItsSbcItIsAtTheSurfaceWithinTheTimeThatCheckPrints) {
  const std::string mission = survey("remus100");
  const Outcome report = runShell("$GLIDERCC check " + mission + " --report");
  ASSERT_EQ(report.status, 0) << report.err;
  ASSERT_THAT(report.out, HasSubstr("the vehicle is assumed to end the override within 33 s"));
  EXPECT_THAT(report.out, HasSubstr("RECON does not state"));
  const std::string words = "it floats to the surface within ";
  const size_t at = report.out.find(words);
  ASSERT_NE(at, std::string::npos) << report.out;
  int minutes = 0, seconds = 0;
  // NOLINTNEXTLINE(cert-err34-c): the count says whether it fits
  ASSERT_EQ(std::sscanf(report.out.c_str() + at + words.size(), "%d min %d s", &minutes, &seconds),
            2);
  int deep = 0;
  for (const double killed_s : {60.0, 75.0, 90.0, 110.0}) {
    const Flight flight = fly(mission + " --kill-sbc-at " + std::to_string(killed_s));
    const auto time = flight.column("time");
    const auto depth = flight.column("true_depth");
    const auto rpm = flight.column("rpm");
    const auto ends = std::ranges::find_if(flight.events, [](const Event& event) {
      return event.what.find("the override has ended") != std::string::npos;
    });
    ASSERT_NE(ends, flight.events.end()) << killed_s;
    EXPECT_LE(ends->time_s, killed_s + 33) << killed_s;
    EXPECT_GE(ends->time_s, killed_s + 27) << "the goals before it count: " << killed_s;
    EXPECT_THAT(ends->what, HasSubstr("its goals have stopped"));
    deep += flight.valueAt("true_depth", killed_s) > 5 ? 1 : 0;
    for (size_t i = 0; i < time.size(); ++i) {
      if (time[i] > killed_s + 60 * minutes + seconds) {
        EXPECT_LT(depth[i], 1) << killed_s << " " << time[i];
      }
      if (time[i] > ends->time_s + 30) {
        EXPECT_LT(std::fabs(rpm[i]), 1) << killed_s << " " << time[i];
      }
    }
    EXPECT_LT(depth.back(), 1) << killed_s;
  }
  EXPECT_GE(deep, 3) << "no test at the surface";
}

TEST_F(Remus100, OneTextFliesOnAllThreeVehicles) {
  const Flight gliding = fly(survey("slocum"));
  EXPECT_EQ(gliding.outcome.status, 0) << gliding.outcome.err;
  EXPECT_EQ(happenings(gliding).size(), 2U);
  for (const char* vehicle : {"lauv", "remus100"}) {
    const Flight propelled = fly(survey(vehicle));
    EXPECT_EQ(propelled.outcome.status, 0) << propelled.outcome.err;
    EXPECT_EQ(happenings(propelled), happenings(gliding)) << vehicle;
  }
}

TEST_F(Remus100, IsDescribedAndItsProgramsAreBuilt) {
  const Outcome text = runShell("$GLIDERCC platform remus100");
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("From the SBC: recon"));
  for (const char* board : {"host", "ts7800", "ts5500"}) {
    const std::string program = (folder_.path() / board).string();
    const Outcome built =
        runShell("$GLIDERCC build " + survey("remus100") + " --target " + board + " -o " + program);
    EXPECT_EQ(built.status, 0) << built.err;
    EXPECT_GT(slurp(program).size(), 10000U) << board;
  }
}

TEST_F(Remus100, ACampaignHasNoViolation) {
  const std::string flights = (folder_.path() / "flights.csv").string();
  const Outcome flown =
      runShell("$GLIDERCC campaign " + survey("remus100") + " --flights 40 --csv " + flights);
  EXPECT_EQ(flown.status, 0) << flown.out << flown.err;
  const std::string rows = slurp(flights);
  EXPECT_EQ(std::ranges::count(rows, '\n'), 42);
  const size_t title = rows.find(",violation,");
  EXPECT_EQ(rows.find(",violation,", title + 1), std::string::npos);
  EXPECT_NE(rows.find(",exited,"), std::string::npos);
}

}  // namespace
}  // namespace glider::tests
