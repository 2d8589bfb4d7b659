// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What `check --mi` says the vehicle does otherwise than the mission happens in a simulated flight
// of a healthy vehicle, and what such a flight shows was said before.

#include "tests/support/command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>
#include <utility>
#include <vector>

namespace glider::tests {
namespace {

/// A mission file and a mission, what check says, and what the flight shows.
struct Row {
  std::string name;
  std::string mi;
  std::string mission;
  double water_m;
  std::string code;   ///< "GL3130"; empty: nothing is said
  std::string event;  ///< part of an event of the flight; empty: none of kTroubles
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name;
}

/// Events of flights in which the vehicle does otherwise than the mission.
constexpr const char* kTroubles[] = {"climb: ", "masks", "MS_ABORT", "has ended normally",
                                     "control revoked"};

std::string abend(const std::string& more = "") {
  return "behavior: abend\nb_arg: overdepth(m) 80\nb_arg: overtime(s) 43200\n" + more;
}
std::string surface(int code, const std::string& more) {
  return fmt::format("behavior: surface\nb_arg: start_when(enum) {}\n{}", code, more);
}
std::string resumes(const std::string& more = "") {
  return "b_arg: end_action(enum) 2\nb_arg: gps_wait_time(s) 0\n" + more;
}
std::string hookbeh(const std::string& more = "b_arg: max_depth(m) 60\n") {
  return "behavior: hookbeh\n" + more;
}
/// Comes up when nothing else commands.
std::string usual() {
  return surface(1, resumes());
}

std::string oneState(const std::string& profile, const std::string& cases,
                     const std::string& head = "") {
  return "mission m\n" + head + "state s\nbegin\n  flightprofile " + profile +
         "\n  sensors missiontime, depth, altitude\n  events\n" + cases + "end\n";
}
std::string yo(double deep, double hours = 1) {
  return oneState(fmt::format("yo(5 m, {} m, 26 deg, 26 deg)", deep),
                  fmt::format("    case missiontime >= {} h exit\n", hours));
}
std::string openEnd() {
  return oneState("yo(5 m, 30 m, 26 deg, 26 deg)", "    case depth > 90 m exit\n");
}
std::string hover(const std::string& last) {
  return oneState("hover_at(20 m)", "    case missiontime >= " + last + " exit\n");
}
std::string avoids(double at) {
  return fmt::format("mission m\nalways\n  case altitude < {} m call up\n", at) +
         "state s\nbegin\n  flightprofile yo(5 m, 50 m, 26 deg, 26 deg)\n  sensors missiontime\n"
         "  events\n    case missiontime >= 1 h exit\nend\n"
         "state up\nbegin\n  flightprofile climb_to(8 m, 26 deg)\n  sensors depth, statetime\n"
         "  events\n    case depth < 10 m return\n    case statetime >= 5 min return\nend\n";
}

std::vector<Row> rows() {
  const std::string after_1200 = "b_arg: when_secs(s) 1200\n";
  return {
      {"a dive to max_depth", abend() + usual() + hookbeh(), yo(60), 120, "GL3130",
       "climb: too deep"},
      {"a dive to 5 m above max_depth", abend() + usual() + hookbeh(), yo(55), 120, "", ""},
      {"a flat dive to max_depth", abend() + usual() + hookbeh("b_arg: max_depth(m) 30\n"),
       oneState("yo(5 m, 30 m, 12 deg, 12 deg)", "    case missiontime >= 1 h exit\n"), 120,
       "GL3130", "climb: too deep"},
      {"a hover at max_depth", abend() + usual() + hookbeh("b_arg: max_depth(m) 20\n"),
       hover("25 min"), 120, "GL3130", "climb: too deep"},
      {"a dive to overdepth", "behavior: abend\nb_arg: overdepth(m) 40\n" + usual() + hookbeh(),
       yo(40), 120, "GL3125", "MS_ABORT_OVERDEPTH"},
      {"an avoidance that comes too late", abend() + usual() + hookbeh(), avoids(4), 30, "GL3131",
       "climb: too near the bottom"},
      {"an avoidance in time", abend() + usual() + hookbeh(), avoids(9), 30, "", ""},
      {"a hover of an hour that abend does not allow",
       abend("b_arg: samedepth_for(s) 200\n") + usual() + hookbeh(), hover("1 h"), 120, "GL3125",
       "MS_ABORT_SAMEDEPTH"},
      {"a hover of an hour", abend() + usual() + hookbeh(), hover("1 h"), 120, "", ""},
      {"a hover of an hour at the surface", abend() + usual() + hookbeh(),
       oneState("surfaced", "    case missiontime >= 1 h exit\n"), 120, "", ""},
      {"a surfacing every 20 min", abend() + surface(9, resumes(after_1200)) + usual() + hookbeh(),
       yo(30), 120, "GL3132", "masks"},
      {"a surfacing after the mission",
       abend() + surface(9, resumes("b_arg: when_secs(s) 5000\n")) + usual() + hookbeh(), yo(30),
       120, "", ""},
      {"a surfacing for want of contact",
       abend() + surface(12, resumes(after_1200)) + usual() + hookbeh(), yo(30), 120, "GL3132",
       "masks"},
      {"a rare one in a mission without a proved end",
       abend() + surface(12, resumes("b_arg: when_secs(s) 21600\n")) + usual() + hookbeh(),
       openEnd(), 120, "", ""},
      {"one in a mission without a proved end",
       abend() + surface(12, resumes("b_arg: when_secs(s) 4800\n")) + usual() + hookbeh(),
       openEnd(), 120, "GL3132", "masks"},
      {"a surfacing below hookbeh", abend() + usual() + hookbeh() + surface(9, resumes(after_1200)),
       yo(30), 120, "", ""},
      {"a heading above hookbeh",
       abend() +
           "behavior: set_heading\nb_arg: use_heading(enum) 1\nb_arg: heading_value(X) 1\n"
           "b_arg: start_when(enum) 0\n" +
           usual() + hookbeh(),
       yo(30), 120, "GL3132", "masks"},
      {"quits before control", abend() + surface(1, "b_arg: end_action(enum) 0\n") + hookbeh(),
       yo(30), 120, "GL3133", "has ended normally"},
      {"quits in the middle",
       abend() + surface(9, "b_arg: end_action(enum) 0\n" + after_1200) + usual() + hookbeh(),
       yo(30), 120, "GL3133", "has ended normally"},
      {"ready after abend has aborted",
       "behavior: abend\nb_arg: overtime(s) 600\n" + usual() +
           hookbeh("b_arg: start_secs(s) 900\n"),
       yo(20), 120, "GL3133", "MS_ABORT_OVERTIME"},
      {"an altimeter that is never read",
       abend() + usual() + hookbeh() + "behavior: sensors_in\nb_arg: c_alt_time(s) -1\n", yo(50),
       200, "GL3134", ""},
  };
}

class CheckFlies : public ::testing::TestWithParam<Row> {
 protected:
  /// The events of a flight of an hour and a half.
  std::string flown(const Row& row, const std::filesystem::path& mission) const {
    (void)folder_.write("v.mi", row.mi);
    const auto scenario = folder_.write(
        "v.toml", fmt::format("name = \"v\"\nskeleton = \"v.mi\"\nduration_s = 5400\nseed = 1\n"
                              "[start]\nlatitude_deg = 39.175\nlongitude_deg = -73.835\n"
                              "[ocean]\nwater_depth_m = {:.1f}\n"
                              "[vehicle]\ndrag = 0.12\n",
                              row.water_m));
    const auto to = folder_.path() / "flight";
    (void)runShell("$GLIDERCC sim " + mission.string() + " --scenario " + scenario.string() +
                   " -o " + to.string());
    return runShell("cat " + (to / "events.csv").string()).out;
  }

  const TemporaryFolder folder_;
};

TEST_P(CheckFlies, WhatIsSaidHappensAndWhatHappensIsSaid) {
  const Row& row = GetParam();
  const auto mission = folder_.write("m.mission", row.mission);
  const Outcome checked = runShell("$GLIDERCC check --mi " +
                                   folder_.write("v.mi", row.mi).string() + " " + mission.string());
  const std::string events = flown(row, mission);
  ASSERT_NE(events, "");
  if (row.code.empty()) {
    EXPECT_THAT(checked.err, testing::Not(testing::ContainsRegex("[[]GL31[23][0-9] [a-z]")))
        << row.name;
    EXPECT_EQ(checked.status, 0) << checked.err;
  } else {
    EXPECT_THAT(checked.err, testing::HasSubstr("[" + row.code)) << row.name;
  }
  if (!row.event.empty()) {
    EXPECT_THAT(events, testing::HasSubstr(row.event)) << row.name << checked.err;
  } else {
    for (const char* trouble : kTroubles) {
      EXPECT_THAT(events, testing::Not(testing::HasSubstr(trouble))) << row.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, CheckFlies, ::testing::ValuesIn(rows()),
                         [](const ::testing::TestParamInfo<Row>& of) {
                           std::string name;
                           bool upper = true;
                           for (const char c : of.param.name) {
                             if (c != ' ') {
                               name += upper ? static_cast<char>(std::toupper(c)) : c;
                             }
                             upper = c == ' ';
                           }
                           return name;
                         });

}  // namespace
}  // namespace glider::tests
