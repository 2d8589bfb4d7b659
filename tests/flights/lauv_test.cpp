// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions for a LAUV, which is steered by IMC, with the command.

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

class Lauv : public testing::Test {
 protected:
  /// A mission of two states for a vehicle; it names neither pitch nor speed.
  [[nodiscard]] std::string survey(const std::string& platform,
                                   const std::string& profile = "yo(5 m, 20 m)") const {
    return folder_
        .write("survey_" + platform + ".mission",
               "mission survey\nplatform " + platform +
                   "\nrequire always depth <= 30 m\nstate down\nbegin\n  flightprofile " + profile +
                   "\n  flightroute heading(90 deg)\n  sensors missiontime, depth\n  events\n"
                   "    case missiontime >= 5 min goto back\nend\n"
                   "state back\nbegin\n  flightprofile yo(3 m, 12 m)\n"
                   "  flightroute heading(270 deg)\n  sensors missiontime, depth\n  events\n"
                   "    case missiontime >= 10 min exit\nend\n")
        .string();
  }
  [[nodiscard]] static Outcome check(const std::string& mission) {
    return runShell("$GLIDERCC check " + mission + " --report");
  }
  [[nodiscard]] static size_t count(const std::string& text, const std::string& part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
      ++found;
    }
    return found;
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

TEST_F(Lauv, FliesTheSameInProcessAndOnBoards) {
  const std::string mission = survey("lauv");
  const Flight here = fly(mission);
  ASSERT_EQ(here.outcome.status, 0) << here.outcome.err;
  const auto depth = here.column("true_depth");
  EXPECT_GT(*std::ranges::max_element(depth), 19.5);
  EXPECT_LT(*std::ranges::max_element(depth), 20.5);
  EXPECT_EQ(here.transitions().size(), 2U);
  for (const char* board : {"host", "ts7800", "ts5500"}) {
    const Flight there = fly(mission + " --board " + board);
    EXPECT_EQ(there.outcome.status, 0) << there.outcome.err;
    EXPECT_TRUE(there.csv == here.csv) << board;
    EXPECT_EQ(happenings(there), happenings(here)) << board;
  }
}

TEST_F(Lauv, WithoutItsSbcItIsAtTheSurfaceWithinTheTimeThatCheckPrints) {
  const std::string mission = survey("lauv");
  const Outcome report = check(mission);
  ASSERT_EQ(report.status, 0) << report.err;
  ASSERT_THAT(report.out, HasSubstr("the vehicle stops its propeller within 18 s"));
  const std::string words = "it floats to the surface within ";
  const size_t at = report.out.find(words);
  ASSERT_NE(at, std::string::npos) << report.out;
  int minutes = 0, seconds = 0;
  // NOLINTNEXTLINE(cert-err34-c): the count says whether it fits
  ASSERT_EQ(std::sscanf(report.out.c_str() + at + words.size(), "%d min %d s", &minutes, &seconds),
            2);
  for (const double killed_s : {60.0, 90.0, 100.0, 130.0}) {
    const Flight flight = fly(mission + " --kill-sbc-at " + std::to_string(killed_s));
    const auto time = flight.column("time");
    const auto depth = flight.column("true_depth");
    const auto rpm = flight.column("rpm");
    const auto ends = std::ranges::find_if(flight.events, [](const Event& event) {
      return event.what.find("plan has ended") != std::string::npos;
    });
    ASSERT_NE(ends, flight.events.end()) << killed_s;
    EXPECT_LE(ends->time_s, killed_s + 18) << killed_s;
    EXPECT_GE(ends->time_s, killed_s + 12) << "the references before it count: " << killed_s;
    EXPECT_THAT(ends->what, HasSubstr("its references have stopped"));
    EXPECT_GT(flight.valueAt("true_depth", killed_s), 5) << "no test at the surface: " << killed_s;
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
}

TEST_F(Lauv, OneTextFliesOnBothVehicles) {
  const Flight propelled = fly(survey("lauv")), gliding = fly(survey("slocum"));
  EXPECT_EQ(propelled.outcome.status, 0) << propelled.outcome.err;
  EXPECT_EQ(gliding.outcome.status, 0) << gliding.outcome.err;
  EXPECT_EQ(happenings(propelled).size(), 2U);
  EXPECT_EQ(happenings(propelled), happenings(gliding));
}

// accepts: GL2196
TEST_F(Lauv, WhatTheOtherKindOfVehicleIsToldIsOneError) {
  const Outcome speed = check(survey("lauv", "yo(5 m, 20 m, 1 m/s)"));
  EXPECT_EQ(speed.status, 0) << speed.err;
  const Outcome pitch = check(survey("slocum", "yo(5 m, 20 m, 26 deg)"));
  EXPECT_EQ(pitch.status, 0) << pitch.err;
  for (const auto& [platform, told] :
       {std::pair{"lauv", "12 deg"}, {"lauv", "0.2 rad"}, {"slocum", "1.2 m/s"}}) {
    const Outcome refused = check(survey(platform, std::string("yo(5 m, 20 m, ") + told + ")"));
    EXPECT_EQ(refused.status, 1) << told;
    EXPECT_EQ(count(refused.err, "error: "), 1U) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("[GL2196 "));
    EXPECT_THAT(refused.err, HasSubstr(std::string("it has no use for `") + told + "`"));
  }
}

// accepts: GL2197
TEST_F(Lauv, CannotHover) {
  const auto with = [&](const std::string& platform, const std::string& command) {
    return check(folder_
                     .write("m.mission", "mission m\nplatform " + platform +
                                             "\nflightprofile rest\nbegin\n  entry do " + command +
                                             " end\nend\nstate s\nbegin\n  flightprofile rest\n"
                                             "  sensors missiontime, depth\n  events\n"
                                             "    case missiontime >= 10 min exit\nend\n")
                     .string());
  };
  const Outcome refused = with("lauv", "hover(10 m)");
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(count(refused.err, "error: "), 1U) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("[GL2197 "));
  const Outcome glides = with("slocum", "hover(10 m)");
  EXPECT_EQ(glides.status, 0) << glides.err;
  EXPECT_EQ(with("lauv", "descend(10 m, 1 m/s)").status, 0);
}

// accepts: GL3144
TEST_F(Lauv, IsToldNoSpeedThatItDoesNotKeep) {
  for (const char* speed : {"0.7 m/s", "1 m/s", "1.6 m/s", "usual_speed"}) {
    const Outcome fine = check(survey("lauv", std::string("level(10 m, ") + speed + ")"));
    EXPECT_EQ(fine.status, 0) << speed << fine.err;
  }
  for (const char* speed : {"0.3 m/s", "0.69 m/s", "0 m/s"}) {
    const Outcome slow = check(survey("lauv", std::string("level(10 m, ") + speed + ")"));
    EXPECT_EQ(slow.status, 1) << speed;
    EXPECT_THAT(slow.err, HasSubstr("[GL3144 ")) << speed;
  }
  EXPECT_EQ(check(survey("lauv", "level(10 m, 1.7 m/s)")).status, 1);
}

TEST_F(Lauv, IsDescribedAndItsProgramsAreBuilt) {
  const Outcome text = runShell("$GLIDERCC platform lauv");
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("From the SBC: imc"));
  EXPECT_THAT(text.out, HasSubstr("0.7 to 1.6 m/s, 1.2 m/s if none is named"));
  for (const char* board : {"host", "ts7800", "ts5500"}) {
    const std::string program = (folder_.path() / board).string();
    const Outcome built =
        runShell("$GLIDERCC build " + survey("lauv") + " --target " + board + " -o " + program);
    EXPECT_EQ(built.status, 0) << built.err;
    EXPECT_GT(slurp(program).size(), 10000U) << board;
  }
}

TEST_F(Lauv, ACampaignOfTwoMissionsHasNoViolation) {
  const std::string level =
      folder_
          .write("level.mission",
                 "mission level\nplatform lauv\nstate down\nbegin\n"
                 "  flightprofile level(15 m, 1.4 m/s)\n  flightroute heading(0 deg)\n"
                 "  sensors missiontime, depth\n  events\n"
                 "    case missiontime >= 6 min goto up\nend\nstate up\nbegin\n"
                 "  flightprofile surfaced\n  sensors missiontime, depth\n  events\n"
                 "    case missiontime >= 8 min exit\nend\n")
          .string();
  const std::string flights = (folder_.path() / "flights.csv").string();
  const Outcome flown = runShell("$GLIDERCC campaign " + survey("lauv") + " " + level +
                                 " --flights 60 --csv " + flights);
  EXPECT_EQ(flown.status, 0) << flown.out << flown.err;
  const std::string rows = slurp(flights);
  EXPECT_EQ(count(rows, "\n"), 62U);
  EXPECT_EQ(count(rows, ",violation,"), 1U) << "in the titles";
  EXPECT_GT(count(rows, ",exited,"), 30U);
  EXPECT_GT(count(rows, ",released,"), 0U) << "some SBCs are gone for good";
}

}  // namespace
}  // namespace glider::tests
