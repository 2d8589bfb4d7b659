// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The strategy namedStates without the others, which would answer first: what it proves, and what
// it must not prove of a promise that is false by a tick, a case or a metre.

#include "tests/proofs/proved_alone.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::tests {
namespace {

bool isProvedAlone(const std::string& promise, const std::string& mission) {
  return tests::isProvedAlone(ir::prove::strategy::namedStates(), promise, mission);
}

std::string always(const std::string& cases) {
  return "always\n" + cases + "\n";
}

const std::string kGlides = "yo(5 m, 30 m, 26 deg, 26 deg)";
const std::string kFly = stateOf("fly", kGlides, "    case temp > 20 degC goto other");
const std::string kOther = stateOf("other", kGlides, "    case temp < 10 degC goto fly");
const std::string kUp = stateOf("up", "surfaced", "    case statetime > 2 h exit");

/// From 35 m to 2 m it takes 120 s and 660 s, and a power cut may hide it for 300 s.
TEST(NamedStates, KnowTheTimeOfAClimb) {
  const std::string mission = always("  case battery < 11 V goto up") + kFly + kOther + kUp;
  EXPECT_TRUE(isProvedAlone("whenever up then depth <= 2 m within 1081 s or exit", mission));
  EXPECT_FALSE(isProvedAlone("whenever up then depth <= 2 m within 1079 s or exit", mission));
  EXPECT_TRUE(isProvedAlone("whenever up then depth < 10 m within 921 s or exit", mission));
  EXPECT_FALSE(isProvedAlone("whenever up then depth < 10 m within 919 s or exit", mission));
}

const std::string kLeak =
    "after missiontime > 0 s: whenever leakvoltage < 2 V then up within 1 min or exit";

TEST(NamedStates, FollowWhatAlwaysCertainlyDoes) {
  EXPECT_TRUE(
      isProvedAlone(kLeak, always("  case leakvoltage < 2 V goto up") + kFly + kOther + kUp));
  EXPECT_FALSE(isProvedAlone(kLeak, kFly + kOther + kUp)) << "no case leads there";
}

TEST(NamedStates, DoNotTrustACaseBelowOneThatFires) {
  EXPECT_FALSE(isProvedAlone(kLeak, always("  case temp > 25 degC goto other\n"
                                           "  case leakvoltage < 2 V goto up") +
                                        kFly + kOther + kUp));
  EXPECT_FALSE(isProvedAlone(kLeak, always("  case temp > 25 degC stay\n"
                                           "  case leakvoltage < 2 V goto up") +
                                        kFly + kOther + kUp));
}

/// `other` keeps the case that leads to it, and all below, from firing.
TEST(NamedStates, DoNotTrustACaseThatALimitKeepsFromFiring) {
  const std::string mission = always(
                                  "  case temp > 25 degC && leakvoltage >= 2 V goto other\n"
                                  "  case leakvoltage < 2 V goto up") +
                              kFly + kOther + kUp;
  EXPECT_FALSE(isProvedAlone(kLeak, mission));
}

TEST(NamedStates, DoNotTrustAGuardThatReadsWhatATickChanges) {
  const std::string counts =
      "var n : number = 0 in 0 .. 5\n" + always("  case n > 2 goto up") +
      stateOf("fly", kGlides, "    case temp > 20 degC do set n = 5 end goto other") + kOther + kUp;
  EXPECT_FALSE(isProvedAlone("whenever n > 2 then up", counts));
  const std::string again = always("  case statetime > 30 min goto up") +
                            stateOf("fly", kGlides, "    case temp > 20 degC goto fly") + kUp;
  EXPECT_FALSE(isProvedAlone("whenever missiontime > 40 min then up within 1 min or exit", again));
}

/// The own cases of a state come first on the tick after a return.
TEST(NamedStates, PutAlwaysOffAfterAReturn) {
  const std::string calls = always("  case missiontime > 20 h goto up") +
                            stateOf("fly", kGlides, "    case temp > 20 degC call other") +
                            stateOf("other", kGlides, "    case temp < 10 degC return") + kUp;
  const std::string promise = "whenever missiontime > 20 h then up within ";
  EXPECT_TRUE(isProvedAlone(promise + "301 s or exit", calls));
  EXPECT_FALSE(isProvedAlone(promise + "290 s or exit", calls));
  const std::string nested = always("  case missiontime > 20 h goto up") +
                             stateOf("fly", kGlides, "    case temp > 20 degC call other") +
                             stateOf("other", kGlides,
                                     "    case temp < 10 degC return\n"
                                     "    case temp > 25 degC call third") +
                             stateOf("third", kGlides, "    case temp < 5 degC return") + kUp;
  EXPECT_FALSE(isProvedAlone(promise + "301 s or exit", nested)) << "two returns, one by one";
}

TEST(NamedStates, EnterEveryStateFromAnywhere) {
  const std::string mission = kFly +
                              stateOf("other", kGlides,
                                      "    case temp < 10 degC goto fly\n"
                                      "    case depth > 5 m goto home\n"
                                      "    case depth < 3 m goto up") +
                              kUp + stateOf("home", "surfaced", "    case statetime > 1 h exit");
  EXPECT_FALSE(isProvedAlone("never home || up && depth > 100 m", mission));
  EXPECT_FALSE(isProvedAlone("never up || home && depth > 100 m", mission));
}

TEST(NamedStates, KnowTheDepthOfAState) {
  const std::string mission = always("  case battery < 11 V goto up") + kFly + kOther + kUp;
  EXPECT_TRUE(isProvedAlone("never up && depth > 35 m", mission));
  EXPECT_FALSE(isProvedAlone("never up && depth > 34 m", mission));
}

TEST(NamedStates, KnowTheRangesOfVariables) {
  const std::string mission =
      "var n : number = 0 in 0 .. 5\n" +
      stateOf("fly", kGlides, "    case temp > 20 degC do set n = min(n + 1, 5) end goto up") +
      stateOf("up", "surfaced", "    case statetime > 2 h goto fly");
  EXPECT_TRUE(isProvedAlone("never up && n > 5", mission));
  EXPECT_FALSE(isProvedAlone("never up && n > 4", mission));
}

TEST(NamedStates, MayEndElsewhere) {
  const std::string mission = always("  case missiontime > 20 h goto up") +
                              stateOf("fly", kGlides, "    case temp > 25 degC exit") + kUp;
  EXPECT_TRUE(isProvedAlone("visit up within 21 h or exit", mission));
  EXPECT_FALSE(isProvedAlone("visit up within 21 h", mission));
}

/// By the clock: no sooner than it allows.
TEST(NamedStates, EndElsewhereByTheClock) {
  const auto ending = [](const std::string& guard) {
    return always("  case missiontime > 20 h goto up") +
           stateOf("fly", kGlides,
                   "    case resumetime > 1 h call other\n    case " + guard + " exit") +
           stateOf("other", kGlides, "    case temp < 10 degC return") + kUp;
  };
  EXPECT_TRUE(isProvedAlone("visit up within 21 h", ending("missiontime > 21 h")));
  EXPECT_FALSE(isProvedAlone("visit up within 21 h", ending("missiontime > 20 h")))
      << "on the tick after a return it ends";
  EXPECT_FALSE(isProvedAlone("visit up within 21 h", ending("missiontime > 19 h")));
  EXPECT_FALSE(
      isProvedAlone("visit up within 21 h", ending("missiontime > 21 h || temp > 25 degC")));
  EXPECT_FALSE(isProvedAlone("visit up within 21 h",
                             always("  case missiontime > 20 h goto up\n"
                                    "  case temp > 25 degC exit") +
                                 stateOf("fly", kGlides, "    case missiontime > 30 h exit") + kUp))
      << "by a case of always";
  EXPECT_FALSE(isProvedAlone(
      "visit up within 21 h",
      always("  case missiontime > 20 h goto up") +
          stateOf("fly", kGlides, "    case statetime < 10 min && temp > 25 degC exit") + kUp))
      << "a clock of the state is not that of the mission";
}

/// After a return the own cases of a state put `always` off only where one may fire so soon.
TEST(NamedStates, PutAlwaysOffOnlyByACaseThatMayFire) {
  const auto calling = [](const std::string& guard) {
    return always("  case missiontime > 20 h goto up") +
           stateOf("fly", kGlides, "    case " + guard + " call other") +
           stateOf("other", kGlides, "    case temp < 10 degC return") + kUp;
  };
  const std::string promise = "whenever missiontime > 20 h then up within 1 s or exit";
  EXPECT_TRUE(isProvedAlone(promise, calling("resumetime > 10 min")));
  EXPECT_FALSE(isProvedAlone(promise, calling("resumetime > 4 min"))) << "a power cut is longer";
  EXPECT_FALSE(isProvedAlone(promise, calling("statetime > 10 min")));
}

/// Clocks of a state that is not followed are those of any stay.
TEST(NamedStates, KnowNoClocksElsewhere) {
  EXPECT_FALSE(isProvedAlone("whenever statetime > 30 min then up within 1 min or exit",
                             kFly + kOther + kUp));
  EXPECT_FALSE(isProvedAlone("whenever resumetime > 30 min then up within 1 min or exit",
                             kFly + kOther + kUp));
}

}  // namespace
}  // namespace glider::tests
