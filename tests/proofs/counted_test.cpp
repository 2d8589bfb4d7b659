// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The strategy counted without the others: what it proves of counters, and what it must not prove
// of one that is reset, skipped or not asked.

#include "tests/proofs/proved_alone.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::tests {
namespace {

const std::string kShallowYo = "yo(5 m, 30 m)";
const std::string kCounter = "var n: number = 0 in 0 .. 9\n";
const std::string kTimer =
    "var talked: time = 0 s\n"
    "always\n"
    "  case missiontime > 4 days exit\n"
    "  case missiontime - talked > 2 h do set talked = missiontime end call talk\n";
const std::string kTalk = stateOf("talk", "surfaced", "    case statetime > 1 h return");
const std::string kNear = stateOf("near", kShallowYo, "    case statetime > 3 h return");

std::string searching(const std::string& cases) {
  return kCounter + kTimer + stateOf("fly", kShallowYo, cases) + kNear + kTalk;
}

bool isCounted(const std::string& promise, const std::string& mission) {
  return isProvedAlone(ir::prove::strategy::counted(), promise, mission);
}

TEST(Counted, KnowTheVisitsThatACounterAllows) {
  const std::string mission =
      searching("    case n < 3 && temp < 10 degC do set n = n + 1 end call near");
  EXPECT_TRUE(isCounted("visit near at most 3 times", mission));
  EXPECT_FALSE(isCounted("visit near at most 2 times", mission));
  EXPECT_FALSE(isCounted("visit talk at most 3 times", mission)) << "it counts nothing";
}

TEST(Counted, DoNotTrustACounterThatIsNotAlwaysAsked) {
  EXPECT_FALSE(isCounted(
      "visit near at most 3 times",
      searching("    case n < 3 || temp < 10 degC do set n = min(n + 1, 9) end call near")));
  EXPECT_FALSE(isCounted("visit near at most 3 times",
                         searching("    case n < 3 do set n = n + 1 end call near\n"
                                   "    case temp < 10 degC call near")));
}

TEST(Counted, DoNotTrustACounterThatIsReset) {
  EXPECT_FALSE(isCounted("visit near at most 3 times",
                         searching("    case n < 3 do set n = n + 1 end call near\n"
                                   "    case temp < 10 degC do set n = 0 end stay")));
  EXPECT_FALSE(isCounted("visit near at most 3 times",
                         searching("    case n < 3 do if temp > 5 degC then set n = n + 1 end end "
                                   "call near")));
}

/// Two conditions are true or false independently of each other.
TEST(Counted, TakeEachConditionByItself) {
  const std::string mission = searching(
      "    case n < 3 && temp < 10 degC do set n = n + 1 end call near\n"
      "    case n < 4 && temp < 10 degC do set n = n + 1 end call near");
  EXPECT_TRUE(isCounted("visit near at most 4 times", mission));
  EXPECT_FALSE(isCounted("visit near at most 3 times", mission));
}

TEST(Counted, ServeNoPromiseWithATime) {
  EXPECT_FALSE(isCounted("visit near at most 3 times or exit",
                         searching("    case temp < 10 degC call near")));
  EXPECT_FALSE(isCounted("patrol near every 9 h",
                         searching("    case n < 3 do set n = n + 1 end call near")));
}

}  // namespace
}  // namespace glider::tests
