// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/heard_missions.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace glider::flights {
namespace {

/// A start of the SBC: the mission time of its checkpoint, and the mission times of its polls.
struct Start {
  std::optional<double> kept;
  std::vector<double> polls;
};

/// What is recorded, a mission a line: the mission time of each tick, and where it does not follow
/// the one before, that of the tick that it follows: "0 4 8 | 4>90 94".
std::string heardOf(const std::vector<Start>& starts) {
  const ir::Mission ir;
  HeardMissions heard(ir);
  GliderMission mission{};
  GliderContext context{};
  context.mission = &mission;
  for (const Start& start : starts) {
    heard.starts(start.kept);
    for (const double time : start.polls) {
      context.mission_time = time;
      heard.look(context, 1000 + time);
    }
  }
  const auto word = [](double time) { return std::to_string(static_cast<int>(time)); };
  std::string text;
  for (const HeardMission& one : heard.missions()) {
    text += text.empty() ? "" : "\n";
    for (size_t i = 0; i < one.ticks.size(); ++i) {
      const KnownTick& tick = one.ticks[i];
      text += i == 0 ? "" : tick.resumed ? " | " : " ";
      if (tick.resumed) {
        text += word(one.ticks.at(tick.before.value()).heard.mission_time) + ">";
      }
      text += word(tick.heard.mission_time);
      EXPECT_EQ(tick.before.has_value(), i != 0);
    }
  }
  return text;
}

TEST(HeardMissions, AProgramThatContinuesAddsToItsMission) {
  EXPECT_EQ(heardOf({{std::nullopt, {0, 0, 4, 8}}, {8, {90, 90, 94}}}), "0 4 8 | 8>90 94");
}

TEST(HeardMissions, FromAnOlderCheckpointItFollowsThatTick) {
  EXPECT_EQ(heardOf({{std::nullopt, {0, 4, 8, 12}}, {4, {90, 94}}}), "0 4 8 12 | 4>90 94");
}

TEST(HeardMissions, OverSeveralOutages) {
  EXPECT_EQ(heardOf({{std::nullopt, {0, 4}}, {4, {20, 24}}, {20, {40}}, {40, {60}}}),
            "0 4 | 4>20 24 | 20>40 | 40>60");
}

TEST(HeardMissions, AProgramThatBeginsAgainMakesANewOne) {
  EXPECT_EQ(heardOf({{std::nullopt, {0, 4, 8}}, {std::nullopt, {0, 4}}, {4, {50}}}),
            "0 4 8\n0 4 | 4>50");
  EXPECT_EQ(heardOf({{std::nullopt, {0, 4, 8}}, {8, {0, 4}}}), "0 4 8\n0 4")
      << "with a checkpoint of another flight";
}

TEST(HeardMissions, AProgramThatLeavesControlAddsNothing) {
  EXPECT_EQ(heardOf({{std::nullopt, {0, 4, 8}}, {8, {}}, {8, {60}}}), "0 4 8 | 8>60");
}

/// The SBC shows the time of its checkpoint until its first tick.
TEST(HeardMissions, TheTimeOfTheCheckpointIsNoTick) {
  EXPECT_EQ(heardOf({{std::nullopt, {0, 4, 8}}, {4, {4, 4, 90}}}), "0 4 8 | 4>90");
}

/// Only an earlier mission's checkpoint has survived.
TEST(HeardMissions, TheCheckpointMayBeOfAnEarlierMission) {
  EXPECT_EQ(heardOf({{std::nullopt, {0, 4, 88}}, {std::nullopt, {0, 4}}, {88, {99}}}),
            "0 4\n0 4 88 | 88>99");
}

TEST(HeardMissions, ACheckpointOfNoTickIsNotFollowed) {
  EXPECT_EQ(heardOf({{std::nullopt, {0, 4, 8}}, {6, {90}}}), "0 4 8");
}

}  // namespace
}  // namespace glider::flights
