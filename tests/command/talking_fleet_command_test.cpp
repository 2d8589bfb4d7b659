// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A fleet whose vehicles tell each other values: `glidercc sim` and `check` of its file.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <gmock/gmock.h>
#include <set>
#include <sstream>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kPlace =
    "share lat in 39 N .. 40 N precision 0.0001 deg every 2 min\n"
    "share lon in 74 W .. 73 W precision 0.0001 deg every 2 min\n";
const std::string kTop = "share top: length in 0 m .. 100 m precision 1 m every 2 min\n";

class TalkingFleet : public ::testing::Test {
 protected:
  /// One that tells its depth, and climbs as soon as it receives another one's.
  void mission(const std::string& name, const std::string& shares) const {
    (void)folder_.write(name + ".mission", "mission " + name + "\n" + shares + R"(
require always depth < 45 m
state out
begin
  flightprofile yo(5 m, 30 m)
  sensors       missiontime, depth, peer.top
  events
    case missiontime >= 40 min exit
    case known(peer.top)       goto near
    case true                  do set top = clamp(depth, 0 m, 100 m) end stay
end
state near
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime, depth, peer.top
  events
    case missiontime >= 40 min exit
    case true                  do set top = clamp(depth, 0 m, 100 m) end stay
end
)");
  }
  /// One that knows the names of its fleet, and climbs as soon as `guard` is true.
  void named(const std::string& name, const std::string& vehicles, const std::string& guard,
             const std::string& more = "") const {
    (void)folder_.write(name + ".mission",
                        "mission " + name + "\n" + vehicles + kTop + kPlace + more + R"(
require always depth < 45 m
state out
begin
  flightprofile yo(5 m, 30 m)
  sensors       missiontime, depth, lat, lon
  events
    case missiontime >= 40 min exit
    case )" + guard + R"(       goto near
    case true                  do set top = clamp(depth, 0 m, 100 m) end stay
end
state near
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime, depth
  events
    case missiontime >= 40 min exit
    case true                  do set top = clamp(depth, 0 m, 100 m) end stay
end
)");
  }
  static std::string vehicle(const std::string& name, const std::string& mission,
                             const std::string& more = "") {
    return "[[vehicle]]\nname = \"" + name + "\"\nmission = \"" + mission + ".mission\"\n" + more;
  }
  void fleet(const std::string& head, const std::string& more = "") const {
    (void)folder_.write("f.toml", head + vehicle("a", "one") +
                                      vehicle("b", "one", "bearing_deg = 90\ndistance_m = 500\n") +
                                      more);
  }
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return runShell("cd " + folder_.path().string() + " && " + arguments);
  }
  [[nodiscard]] std::string slurped(const std::string& file) const {
    return slurp(folder_.path() / file);
  }
  /// What the check says of the fleet whose vehicles have these shares.
  [[nodiscard]] std::string refusal(const std::string& one, const std::string& other) const {
    mission("one", one);
    mission("two", other);
    (void)folder_.write("f.toml", vehicle("a", "one") + vehicle("b", "two"));
    const Outcome checked = run("$GLIDERCC check f.toml");
    const Outcome flown = run("$GLIDERCC sim f.toml -o f");
    EXPECT_NE(flown.status, 0);
    EXPECT_THAT(checked.err, HasSubstr("[GL9304 "));
    EXPECT_THAT(flown.err, HasSubstr("[GL9304 "));
    return checked.err;
  }

  const TemporaryFolder folder_;
};

/// The seed is that of the water between the modems too.
TEST_F(TalkingFleet, WhatIsLostDependsOnTheSeed) {
  mission("one", kTop);
  fleet("");
  std::set<std::string> lost;
  for (const char* seed : {"1", "2", "3", "4"}) {
    EXPECT_EQ(run(std::string("$GLIDERCC sim f.toml -o f --seed ") + seed).status, 0);
    const auto report = nlohmann::json::parse(slurped("f/flight.json"));
    lost.insert(report["vehicles"][0]["modem"]["lost"].dump() + " " +
                report["vehicles"][1]["modem"]["lost"].dump());
  }
  EXPECT_GT(lost.size(), 1U);
}

// accepts: GL9304
TEST_F(TalkingFleet, HearsWhatOthersTell) {
  mission("one", kTop);
  fleet("");
  const Outcome flown = run("$GLIDERCC sim f.toml -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("messages  sent"));
  EXPECT_THAT(slurped("f/report.html"), HasSubstr("<h2>Messages</h2>"));
  for (const char* name : {"a", "b"}) {
    const std::string events = slurped(std::string("f/") + name + "/events.csv");
    EXPECT_THAT(events, HasSubstr("out → near (goto)")) << name;
    EXPECT_THAT(events, HasSubstr(name == std::string("a") ? "received a mini packet from 2"
                                                           : "received a mini packet from 1"));
  }
  EXPECT_EQ(run("$GLIDERCC sim f.toml -o g && diff -r f g").status, 0) << "the same again";
}

/// All that arrives is noise.
TEST_F(TalkingFleet, FliesOnWhenNothingArrives) {
  mission("one", kTop);
  const std::string sea = std::filesystem::path(GLIDER_SOURCE_DIR) / "scenarios" / "default.toml";
  (void)folder_.write("noise.toml", slurp(sea) + "\n[[faults.modem]]\nfrom_s = 0\nto_s = 100000\n");
  fleet("scenario = \"noise.toml\"\n");
  const Outcome flown = run("$GLIDERCC sim f.toml -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(slurped("f/a/events.csv"), Not(HasSubstr("goto")));
  EXPECT_THAT(slurped("f/a/events.csv"), HasSubstr("lost a message from 2: "));
  const auto summary = nlohmann::json::parse(slurped("f/flight.json"));
  EXPECT_EQ(summary["vehicles"][0]["modem"]["received"], 0);
}

TEST_F(TalkingFleet, TakesTheTimeAndEnergyThatTheReportSays) {
  struct Kind {
    std::string share, energy, on_air;
    double length_s, send_J;
  };
  for (const Kind& kind : {Kind{kTop, "5.9 J for a mini packet", "1,080", 1.5, 5.88},
                           Kind{"share top: length in 0 m .. 100 m precision 0.05 m every 2 min\n",
                                "15.7 J for a frame", "3,960", 5.5, 15.7}}) {
    mission("one", kind.share);
    fleet("");
    EXPECT_EQ(run("$GLIDERCC sim f.toml -o f").status, 0);
    const auto modem = nlohmann::json::parse(slurped("f/flight.json"))["vehicles"][0]["modem"];
    // 40 min in turns of 38 s, so every 152 s at the soonest: 15 or 16 messages, and two minutes
    // around the mission.
    const double sent = modem["sent"];
    EXPECT_NEAR(sent, 16, 1.01);
    EXPECT_NEAR(modem["on_air_s"].get<double>(), kind.length_s * sent, 0.05 * kind.length_s * sent);
    EXPECT_NEAR(modem["sent_J"].get<double>(), kind.send_J * sent, 0.05 * kind.send_J * sent);
    const std::string report = run("$GLIDERCC check --report --target ts7800 one.mission").out;
    EXPECT_THAT(report, HasSubstr("to send " + kind.energy + ", 6912 J to listen"));
    EXPECT_THAT(report,
                testing::ContainsRegex("on air +" + kind.on_air + " s a day +720 messages"));
  }
}

TEST_F(TalkingFleet, TheCheckSaysHowTheyTakeTurns) {
  mission("one", kTop);
  fleet("");
  const Outcome checked = run("$GLIDERCC check f.toml");
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("they take turns in 2 slots of 19 s, a round every 38 s"));
}

// rejects: GL9304
TEST_F(TalkingFleet, MustUnderstandEachOther) {
  EXPECT_THAT(refusal(kTop, "share top: length in 0 m .. 100 m precision 2 m every 2 min\n"),
              HasSubstr("`a` and `b` do not share `top` alike"));
  EXPECT_THAT(refusal(kTop, kTop + "share depth in 0 m .. 9 m precision 1 m every 5 min\n"),
              HasSubstr("do not share `depth` alike"));
}

TEST_F(TalkingFleet, MustMeanTheSameByTheirNumbers) {
  EXPECT_THAT(refusal(kTop + "share more: length in 0 m .. 9 m precision 1 m every 5 min\n",
                      kTop + "share more: time in 0 s .. 9 s precision 1 s every 5 min\n"),
              HasSubstr("do not share `more` alike"));
}

TEST_F(TalkingFleet, ADifferenceBetweenVersionsIsWhatIsShared) {
  mission("one", kTop);
  mission("two", "share top: length in 0 m .. 100 m precision 2 m every 2 min\n");
  EXPECT_THAT(run("$GLIDERCC diff one.mission two.mission").out,
              HasSubstr("changed: `top`, 101 values from 0 in steps of 1, every 120 s; now 51"));
}

/// A counterexample in which something was received.
TEST_F(TalkingFleet, ReplaysWhatWasReceived) {
  mission("one", kTop + "require never near\n");
  EXPECT_EQ(run("$GLIDERCC check --traces t one.mission").status, 1);
  const Outcome replayed = run("$GLIDERCC sim --replay t/requirement-1/trace.json one.mission");
  EXPECT_THAT(replayed.out + replayed.err, Not(HasSubstr("does not follow")));
  EXPECT_THAT(replayed.out, HasSubstr("in-process followed the counterexample"));
}

/// One mission for both: nothing is received from the vehicle itself.
TEST_F(TalkingFleet, KnowsWhoTells) {
  named("one", "vehicles a, b\n", "known(b.top)");
  fleet("");
  EXPECT_EQ(run("$GLIDERCC sim f.toml -o f").status, 0);
  EXPECT_THAT(slurped("f/a/events.csv"), HasSubstr("out → near (goto)"));
  EXPECT_THAT(slurped("f/b/events.csv"), HasSubstr("received"));
  EXPECT_THAT(slurped("f/b/events.csv"), Not(HasSubstr("goto")));
}

TEST_F(TalkingFleet, KnowsHowFarTheOthersAre) {
  for (const auto& [guard, is_true] :
       {std::pair("nearest < 1 km", true), std::pair("nearest < 100 m", false),
        std::pair("peers within 1 km == 1", true), std::pair("peers within 1 km > 1", false),
        std::pair("known(nearest) && peers within 100 m == 0", true)}) {
    named("one", "vehicles a, b, c\n", guard);
    fleet("");
    EXPECT_EQ(run("$GLIDERCC sim f.toml -o f").status, 0);
    for (const char* name : {"a", "b"}) {
      const bool fired =
          slurped(std::string("f/") + name + "/events.csv").find("goto") != std::string::npos;
      EXPECT_EQ(fired, is_true) << guard << ' ' << name;
    }
  }
}

/// What is proved holds for anything that a named vehicle tells, and the flight that shows the
/// opposite has what it told.
TEST_F(TalkingFleet, ReplaysWhatNamedVehiclesTell) {
  for (const char* guard :
       {"b.top > 50 m && a.top < 3 m", "known(nearest)", "peers within 20000 km >= 1"}) {
    named("one", "vehicles a, b\n", guard, "require never near\n");
    const Outcome checked = run("$GLIDERCC check --traces t one.mission");
    EXPECT_EQ(checked.status, 1) << guard << checked.out;
    const Outcome replayed = run("$GLIDERCC sim --replay t/requirement-1/trace.json one.mission");
    EXPECT_THAT(replayed.out, HasSubstr("in-process followed the counterexample"))
        << guard << replayed.err;
  }
}

TEST_F(TalkingFleet, ADifferenceBetweenVersionsIsWhoIsNamed) {
  named("one", "vehicles a, b\n", "known(b.top)");
  named("two", "vehicles b, a\n", "known(b.top)");
  EXPECT_THAT(run("$GLIDERCC diff one.mission two.mission").out,
              HasSubstr("now named `b`, `a`, before `a`, `b`"));
}

/// The example: three gliders that begin on one half of a loop.
TEST_F(TalkingFleet, KeepsAThirdOfALoopBetweenThem) {
  const std::string loop = std::filesystem::path(GLIDER_SOURCE_DIR) / "missions/fleet/loop";
  EXPECT_THAT(run("$GLIDERCC check " + loop + ".mission").out, HasSubstr("4 requirements proved"));
  EXPECT_EQ(run("$GLIDERCC sim " + loop + ".toml -o f").status, 0);
  std::istringstream rows(slurped("f/distances.csv"));
  std::string row;
  std::getline(rows, row);  // its titles
  double least_before = 1e9, least_after = 1e9, most_after = 0;
  while (std::getline(rows, row)) {
    double time = 0, one = 0, two = 0, three = 0;
    if (std::sscanf(row.c_str(), "%lf,%lf,%lf,%lf", &time, &one, &two, &three) != 4) {
      continue;
    }
    const double least = std::min({one, two, three});
    if (time < 600) {
      least_before = std::min(least_before, least);
    } else if (time > 5 * 3600 && time < 10.5 * 3600) {
      least_after = std::min(least_after, least);
      most_after = std::max({most_after, one, two, three});
    }
  }
  EXPECT_LT(least_before, 950) << "a sixth of the loop";
  EXPECT_GT(least_after, 1250) << "a third is 1560 m";
  EXPECT_LT(most_after, 1800) << "of a loop of 1800 m";
}

// rejects: GL9304
TEST_F(TalkingFleet, MustHaveTheNamesOfTheFleetFile) {
  const std::string guard = "known(a.top)";
  const auto refused = [&](const std::string& first, const std::string& second,
                           const std::string& file) {
    named("one", first, guard);
    named("two", second, guard);
    (void)folder_.write("f.toml", file);
    EXPECT_NE(run("$GLIDERCC sim f.toml -o f").status, 0);
    return run("$GLIDERCC check f.toml").err;
  };
  const std::string line = "vehicles a, b\n", ab = vehicle("a", "one") + vehicle("b", "two");
  EXPECT_THAT(refused(line, line, vehicle("b", "one") + vehicle("a", "two")),
              HasSubstr("`b` has address 1, but the line `vehicles` has `a` there"));
  EXPECT_THAT(refused(line, line,
                      vehicle("a", "one", "address = 1\n") + vehicle("c", "two", "address = 3\n")),
              HasSubstr("`c` has address 3, but the line `vehicles` has only 2"));
  EXPECT_THAT(refused(line, "vehicles a, b, c\n", ab),
              HasSubstr("`a` and `b` do not have the same line `vehicles`"));
  named("one", line, guard);
  named("two", "", "known(peer.top)");
  (void)folder_.write("f.toml", ab);
  const Outcome good = run("$GLIDERCC check f.toml");
  EXPECT_EQ(good.status, 0) << "one of them has no names: " << good.err;
  (void)folder_.write("f.toml", vehicle("a", "one") + vehicle("zoe", "two"));
  EXPECT_THAT(run("$GLIDERCC check f.toml").err,
              HasSubstr("`zoe` has address 2, but the line `vehicles` has `b` there"))
      << "`a` would take what zoe tells for b's";
}

// rejects: GL9304
TEST_F(TalkingFleet, MustHaveTheTimeForTheirTurns) {
  mission("one", kTop);
  std::string more;
  for (int i = 0; i < 8; ++i) {
    more += vehicle("v" + std::to_string(i), "one");
  }
  fleet("", more);
  EXPECT_THAT(run("$GLIDERCC check f.toml").err,
              HasSubstr("`top` is shared every 120 s, but a round of 10 slots takes 190 s"));
  for (int i = 8; i < 14; ++i) {
    more += vehicle("v" + std::to_string(i), "one");
  }
  fleet("", more);
  EXPECT_THAT(run("$GLIDERCC check f.toml").err,
              HasSubstr("it has 16 vehicles, but its modems have only 15 addresses"));
}

}  // namespace
}  // namespace glider::tests
