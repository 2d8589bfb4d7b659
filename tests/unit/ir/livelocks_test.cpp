// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// GL3114: states between which the clocks alone send a mission back and forth.

#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "support/diagnostics/ids/verification.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <gmock/gmock.h>

namespace glider::ir::prove {
namespace {

using testing::HasSubstr;

/// The messages of GL3114; empty: none.
std::string said(const std::string& text) {
  const Mission mission = missionOf(kHeader + text);
  support::DiagnosticEngine diagnostics;
  const MissionFacts facts = verify(mission, diagnostics);
  (void)prove(mission, facts, slocum(), {}, diagnostics);
  std::string all;
  for (const auto& diagnostic : diagnostics.sorted()) {
    all += diagnostic.id == support::diagnostics::clockLivelock ? diagnostic.message + "\n" : "";
  }
  return all;
}

const std::string kExit = "case (ge missiontime 2000:time) exit ";

TEST(Livelocks, BetweenACallerAndItsCalledStateAreFound) {
  EXPECT_THAT(said(stateText("a", kExit + "case (ge missiontime 500:time) call b") +
                   stateText("b", "case (ge missiontime 100:time) return")),
              HasSubstr("at 500 s, the clocks alone switch the mission between `a` and `b`"));
}

TEST(Livelocks, OfThreeStatesAndOfAlwaysAreFound) {
  EXPECT_NE(said(stateText("a", kExit + "case (gt missiontime 500:time) goto b") +
                 stateText("b", "case (ge missiontime 5:time) goto c") +
                 stateText("c", "case (ge statetime 1:time) goto a")),
            "");
  EXPECT_NE(said("always case (ge missiontime 500:time) call b\n" +
                 stateText("a", kExit + "case false goto a") +
                 stateText("b", "case (ge missiontime 100:time) return")),
            "");
  EXPECT_THAT(said(stateText("a", kExit + "case (ge missiontime 500:time) goto a")),
              HasSubstr("`a` and itself"));
}

TEST(Livelocks, ByGuardsThatAreTrueBeforeATimeAreFound) {
  EXPECT_NE(said(stateText("a", kExit + "case (lt missiontime 500:time) goto b") +
                 stateText("b", kExit + "case (lt missiontime 600:time) goto a")),
            "");
}

TEST(Livelocks, NoneIsReportedIfASensorOrAVariableDecides) {
  EXPECT_EQ(said(stateText("a", kExit + "case (and (ge missiontime 500:time) (gt (sensor depth) "
                                        "5:length)) call b") +
                 stateText("b", "case (ge missiontime 100:time) return")),
            "");
  EXPECT_EQ(
      said("variable n: number mission lowest 0 highest 5\ninitial n 0\n" +
           stateText("a", kExit + "case (and (ge missiontime 500:time) (lt (var n) 3)) call b") +
           stateText("b", "case (ge missiontime 100:time) return")),
      "");
  EXPECT_EQ(said(stateText("a", kExit + "case (known (sensor depth)) stay "
                                        "case (ge missiontime 500:time) goto b") +
                 stateText("b", "case true goto a")),
            "");
}

TEST(Livelocks, NoneIsReportedIfAStateLastsForSomeTicks) {
  EXPECT_EQ(said(stateText("a", kExit + "case (ge missiontime 500:time) call b") +
                 stateText("b", "case (ge resumetime 60:time) return")),
            "");
  EXPECT_EQ(said(stateText("a", kExit + "case (and (ge missiontime 500:time) (lt missiontime "
                                        "1500:time)) call b") +
                 stateText("b", "case (ge missiontime 1500:time) return")),
            "")
      << "Figure 2";
  EXPECT_EQ(said(stateText("a", "case (ge missiontime 500:time) goto b") +
                 stateText("b", "case (ge missiontime 500:time) goto c") + stateText("c", kExit)),
            "");
}

TEST(Livelocks, NotAtATimeAtWhichTheStateHasBeenLeft) {
  EXPECT_EQ(said(stateText("a",
                           "case (ge statetime 60:time) goto z "
                           "case (ge missiontime 500:time) goto b") +
                 stateText("b", "case (ge missiontime 400:time) goto a") +
                 stateText("z", "case (ge missiontime 100:time) exit")),
            "")
      << "nothing stays in `a` for 500 s";
}

TEST(Livelocks, NotAtATimeBeforeWhichTheStateCannotBeEntered) {
  const std::string b = stateText("b", kExit + "case (lt missiontime 500:time) goto c");
  const std::string c = stateText("c", kExit + "case (lt missiontime 500:time) goto b");
  const auto after = [&](const std::string& guard) {
    return said(stateText("a", kExit + "case " + guard + " goto b") + b + c);
  };
  EXPECT_EQ(after("(ge missiontime 1000:time)"), "");
  EXPECT_EQ(after("(gt statetime 600:time)"), "");
  EXPECT_EQ(after("(and (gt (sensor depth) 5:length) (ge resumetime 500:time))"), "");
  EXPECT_EQ(after("(gt (sensor depth) 500:length)"), "") << "the sensor ends at 100 m";
  EXPECT_THAT(after("(ge missiontime 300:time)"), HasSubstr("at 304 s, "));
  EXPECT_EQ(said("always case (ge missiontime 700:time) goto b\n" +
                 stateText("a", kExit + "case false goto a") + b + c),
            "");
  EXPECT_EQ(said(stateText("a", kExit + "case (ge statetime 300:time) call z") +
                 stateText("z", kExit + "case (ge statetime 300:time) goto b") + b + c),
            "")
      << "one stay after the other";
}

/// The lines on states that can follow each other on tick after tick.
std::string livelocks(const std::string& text, const platforms::Platform& platform = slocum()) {
  const Mission mission = missionOf(text);
  support::DiagnosticEngine diagnostics;
  const MissionFacts facts = verify(mission, diagnostics);
  Options options;
  options.report = true;
  std::string all;
  for (const auto& line : prove(mission, facts, platform, options, diagnostics).lines) {
    all +=
        line.text.find("can alternate on every tick") != std::string::npos ? line.text + "\n" : "";
  }
  return all;
}

const std::string kCold = "case (lt (sensor temp) 12:temperature) goto a ";

/// A `return` that never fires is not an error: the search for states that follow each other on
/// tick after tick takes none from an empty stack.
TEST(Chattering, AStateWithAReturnThatNeverFires) {
  livelocks(kHeader + stateText("a", kExit + "case (gt (sensor temp) 10:temperature) goto b") +
            stateText("b", kCold + "case false return"));
}

TEST(Chattering, NotAtTimesThatCannotBe) {
  const auto after = [](const std::string& guard) {
    return livelocks(kHeader +
                     "variable t: time mission lowest -100 highest 5000\ninitial t 1:time\n" +
                     stateText("a", kExit + "case (and (gt (sensor temp) 10:temperature) " + guard +
                                        ") goto b") +
                     stateText("b", kCold));
  };
  for (const char* clock : {"missiontime", "statetime", "resumetime"}) {
    const std::string name = clock;
    EXPECT_NE(after("(lt " + name + " (var t))"), "") << name;
    EXPECT_EQ(after("(lt " + name + " (min (var t) 0:time))"), "") << name;
  }
  EXPECT_EQ(after("(and (lt missiontime (min (var t) 0:time)) (and (lt statetime 900:time) "
                  "(lt resumetime 900:time)))"),
            "");
}

TEST(Chattering, WhatAVariableHoldsIsInItsRange) {
  const auto above = [](const std::string& limit) {
    return livelocks(kHeader +
                     "variable t: temperature mission lowest 15 highest 20\ninitial t "
                     "15:temperature\n" +
                     stateText("a", kExit + "case (gt (sensor temp) (var t)) goto b") +
                     stateText("b", "case (lt (sensor temp) " + limit + ":temperature) goto a"));
  };
  EXPECT_NE(above("15.5"), "");
  EXPECT_EQ(above("14.9"), "") << "no value of t is below 15";
}

TEST(Chattering, SayHowLongTheStateWasCurrent) {
  EXPECT_THAT(
      livelocks(kHeader +
                stateText("a", kExit + "case (and (gt (sensor temp) 10:temperature) (and (gt "
                                       "missiontime 900:time) (lt statetime 10:time))) goto b") +
                stateText("b", kCold)),
      testing::ContainsRegex("missiontime = [0-9.]+ s, statetime = [0-9](\\.[0-9]+)? s"));
}

/// From 86 s to `until` by a case of the state, from 98 s by one of `always`, 4 s later back.
TEST(Chattering, ByTheSameCaseTwice) {
  const auto between = [](const char* from, const char* to) {
    return std::string("case (and (ge missiontime ") + from + ":time) (le missiontime " + to +
           ":time)) goto ";
  };
  const auto until = [&](const char* last) {
    return livelocks(kHeader + "always " + between("98", "100") + "b " + between("102", "104") +
                     "a\n" + stateText("a", between("86", last) + "b " + kExit) +
                     stateText("b", between("90", "96") + "a"));
  };
  EXPECT_NE(until("97.9"), "");
  EXPECT_EQ(until("92"), "");
}

/// The noise of the pressure is 0.01 bar.
TEST(Chattering, TheNoiseIsInTheVehiclesUnit) {
  const auto apart = [](const char* pressure) {
    return livelocks(
        kHeader +
        "sensor p: pressure vehicle sci_water_pressure id 3 encoding linear to_si 100000 "
        "lowest 0 highest 100 stale_after 20\n" +
        stateText("a", kExit + "case (gt (sensor p) 200000:pressure) goto b") +
        stateText("b", std::string("case (lt (sensor p) ") + pressure + ":pressure) goto a"));
  };
  EXPECT_THAT(apart("198100"), HasSubstr("within the noise"));
  EXPECT_EQ(apart("197900"), "");
}

/// The difference of two numbers that combine degrees and minutes has no meaning.
TEST(Chattering, NoNoiseOfAPlace) {
  platforms::Platform noisy = slocum();
  for (platforms::PlatformSensor& sensor : noisy.sensors) {
    sensor.noise = sensor.name == "m_lat" ? 0.5 : sensor.noise;
  }
  EXPECT_EQ(
      livelocks(
          kHeader +
              "sensor lat: latitude vehicle m_lat id 3 encoding degrees_minutes to_si 1 lowest "
              "-9000 highest 9000 stale_after 20\n" +
              stateText("a", kExit + "case (gt (sensor lat) 39:latitude) goto b") +
              stateText("b", "case (lt (sensor lat) 39:latitude) goto a"),
          noisy),
      "");
}

}  // namespace
}  // namespace glider::ir::prove
