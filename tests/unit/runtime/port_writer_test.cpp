// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is written to the vehicle's port, as the vehicle receives it: each value by itself, late,
// and sometimes not at all.

#include "runtime/extctl/port_writer.h"

#include "hooks/extctl/sentence.h"
#include "hooks/protocol/decimal.h"
#include "runtime/extctl/stock_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace glider::runtime::extctl {
namespace {

using hooks::extctl::PortSensor;

constexpr GliderPortMission kCommon{60, 0.7854, 0.19, 10, 4711, 0, 0, 0, 0};
constexpr GliderPortMission kModes{60, 0.7854, 0.19, 10, 4711, 0, 0, 0, 1};

/// What a sentence or two write: values by index, and the mode bits under -1.
std::map<int, double> valuesIn(std::string_view bytes) {
  std::map<int, double> values;
  hooks::extctl::SentenceReader reader;
  for (const char c : bytes) {
    if (!reader.push(static_cast<uint8_t>(c))) {
      continue;
    }
    const std::string body(reader.body(), reader.size());
    if (body.starts_with("MD,")) {
      values[-1] = std::stod(body.substr(body.rfind(',') + 1));
      continue;
    }
    EXPECT_TRUE(body.starts_with("SW,")) << body;
    for (size_t at = 2; at != std::string::npos; at = body.find(',', at + 1)) {
      values[std::stoi(body.substr(at + 1))] = std::stod(body.substr(body.find(':', at) + 1));
    }
  }
  return values;
}

std::map<int, double> answerOf(PortWriter& writer) {
  char text[PortWriter::kMostBytes];
  return valuesIn({text, writer.write({1, 0}, true, text, sizeof text)});
}

StockCommand between(double climb_m, double dive_m) {
  StockCommand command;
  command.climb_depth_m = climb_m;
  command.dive_depth_m = dive_m;
  command.surface = false;
  command.modes = 0;
  return command;
}

/// How deep the vehicle has just been.
Whereabouts having(double deep_m) {
  return {.deep_m = deep_m};
}

bool has(const std::map<int, double>& values, PortSensor sensor) {
  return values.contains(static_cast<int>(sensor));
}

double of(const std::map<int, double>& values, PortSensor sensor) {
  const auto found = values.find(static_cast<int>(sensor));
  return found == values.end() ? NAN : found->second;
}

TEST(PortWriter, WritesEverythingFirstAndEverySixteenSeconds) {
  PortWriter writer(kCommon, true);
  int all = 0;
  for (int second = 0; second < 64; second += 4) {
    writer.tell(between(5, 40), second);
    const auto values = answerOf(writer);
    EXPECT_TRUE(has(values, PortSensor::Beat));
    all += values.size() == hooks::extctl::kWrittenSensors ? 1 : 0;
    EXPECT_FALSE(values.contains(-1)) << "the release has no modes";
  }
  EXPECT_GE(all, 64 / 16);
}

TEST(PortWriter, AValueThatChangesIsWrittenThreeTimes) {
  PortWriter writer(kCommon, true);
  double now = 0;
  for (; now < 20; now += 4) {
    writer.tell(between(5, 40), now);
    (void)answerOf(writer);
  }
  StockCommand turned = between(5, 40);
  turned.heading_rad = 1.25;
  int times = 0;
  for (const double until = now + 12; now < until; now += 4) {
    writer.tell(turned, now);
    times += of(answerOf(writer), PortSensor::Heading) == 1.25 ? 1 : 0;
  }
  EXPECT_EQ(times, 3);
}

TEST(PortWriter, ARestartOfTheOtherEndGetsEverythingAgain) {
  PortWriter writer(kCommon, true);
  for (double now = 0; now <= 4; now += 4) {
    writer.tell(between(5, 40), now);
    (void)answerOf(writer);
  }
  writer.tell(between(5, 40), 8);
  writer.forget();
  EXPECT_EQ(answerOf(writer).size(), hooks::extctl::kWrittenSensors);
}

/// When `sensor` is first written with `value`, s; a command is in force from `from_s` on.
double firstWritten(PortWriter& writer, const StockCommand& command, double from_s,
                    PortSensor sensor, double value) {
  for (double now = from_s; now < from_s + 200; now += 4) {
    writer.tell(command, now);
    if (of(answerOf(writer), sensor) == value) {
      return now;
    }
  }
  return NAN;
}

TEST(PortWriter, WhatIsLostInARestartOfThePortSettlesAnew) {
  PortWriter writer(kCommon, true);
  (void)firstWritten(writer, between(30, 40), 0, PortSensor::ClimbDepth, 30);
  for (double now = 60; now < 100; now += 4) {
    writer.tell(between(30, 40), now);
  }
  writer.tell(between(5, 15), 100);
  EXPECT_EQ(of(answerOf(writer), PortSensor::ClimbDepth), 5);
  writer.forget();  // the port is away for a minute
  EXPECT_GE(firstWritten(writer, between(5, 15), 160, PortSensor::DiveDepth, 15),
            160 + hooks::extctl::kSettleSecs)
      << "the climb at 30 m may still be in force";
}

TEST(PortWriter, SoDoesWhetherItIsToSurface) {
  PortWriter writer(kCommon, true);
  StockCommand up = between(1, 6);
  up.surface = true;
  for (double now = 0; now < 100; now += 4) {
    writer.tell(up, now);
    (void)answerOf(writer);
  }
  writer.tell(between(1, 20), 100);
  EXPECT_EQ(of(answerOf(writer), PortSensor::DiveDepth), 20);
  writer.forget();  // the port is away for a minute
  EXPECT_GE(firstWritten(writer, between(1, 20), 160, PortSensor::WantsSurface, 0),
            160 + hooks::extctl::kSettleSecs)
      << "the dive may not have arrived";
}

TEST(PortWriter, AnUnknownStartIsMadeTheShallowestClimbFirst) {
  PortWriter writer(kCommon, false);
  writer.tell(between(30, 40), 0);
  const auto first = answerOf(writer);
  EXPECT_EQ(of(first, PortSensor::ClimbDepth), hooks::extctl::kFirstClimbDepth);
  EXPECT_FALSE(of(first, PortSensor::DiveDepth) == 40);
  const double dive = firstWritten(writer, between(30, 40), 4, PortSensor::DiveDepth, 40);
  EXPECT_GE(dive, hooks::extctl::kSettleSecs);
  EXPECT_GE(firstWritten(writer, between(30, 40), dive, PortSensor::ClimbDepth, 30),
            dive + hooks::extctl::kSettleSecs);
}

TEST(PortWriter, NorDoesAnUnknownStartDiveBeforeItsTargetHasArrived) {
  PortWriter writer(kModes, false);
  const double down = firstWritten(writer, between(1, 6), 0, PortSensor::WantsSurface, 0);
  PortWriter twin(kModes, false);
  const double dive = firstWritten(twin, between(1, 6), 0, PortSensor::DiveDepth, 6);
  EXPECT_GE(down, dive + hooks::extctl::kSettleSecs) << "a dive to 60 m may be in force";
}

TEST(PortWriter, AKnownDeepTargetIsOverBeforeTheVehicleLeavesTheSurface) {
  PortWriter writer(kModes, true);
  (void)firstWritten(writer, between(30, 40), 0, PortSensor::ClimbDepth, 30);
  StockCommand up = between(1, 40);
  up.surface = true;
  for (double now = 200; now < 300; now += 4) {
    writer.tell(up, now);
    (void)answerOf(writer);
  }
  double dive_s = NAN, down_s = NAN;
  for (double now = 300; now < 400; now += 4) {
    writer.tell(between(1, 6), now);
    const auto values = answerOf(writer);
    dive_s = std::isnan(dive_s) && of(values, PortSensor::DiveDepth) == 6 ? now : dive_s;
    down_s = std::isnan(down_s) && of(values, PortSensor::WantsSurface) == 0 ? now : down_s;
  }
  EXPECT_GE(down_s, dive_s + hooks::extctl::kSettleSecs);
}

TEST(PortWriter, ATargetThatChangesAllTheTimeDoesNotKeepTheVehicleUp) {
  PortWriter writer(kModes, true);
  double down_s = NAN;
  for (double now = 0; now < 200; now += 4) {
    writer.tell(between(1, 60 - now / 8), now);
    const auto values = answerOf(writer);
    down_s = std::isnan(down_s) && of(values, PortSensor::WantsSurface) == 0 ? now : down_s;
  }
  EXPECT_LE(down_s, 2 * hooks::extctl::kSettleSecs + 4);
}

TEST(PortWriter, AClockThatIsSetBackBlocksNothing) {
  PortWriter writer(kCommon, true);
  for (double now = 5000; now < 5100; now += 4) {
    writer.tell(between(30, 40), now);
    (void)answerOf(writer);
  }
  writer.tell(between(28, 38), 5100);
  EXPECT_LE(firstWritten(writer, between(5, 15), 1000, PortSensor::DiveDepth, 15),
            1000 + hooks::extctl::kSettleSecs + 4);
}

TEST(PortWriter, UpAtOnceAndDownOnlyWhenTheDepthsHaveArrived) {
  PortWriter writer(kModes, true);
  StockCommand up = between(5, 40);
  up.surface = true;
  up.modes = kGliderPortModeSurface;
  writer.tell(up, 0);
  auto values = answerOf(writer);
  EXPECT_EQ(of(values, PortSensor::WantsSurface), kSurfaceNow);
  EXPECT_EQ(values.at(-1), kGliderPortModeSurface);
  double left_s = NAN;
  for (double now = 4; now < 80; now += 4) {
    writer.tell(between(20, 30), now);
    values = answerOf(writer);
    if (std::isnan(left_s) && of(values, PortSensor::WantsSurface) == 0) {
      left_s = now;
    }
  }
  EXPECT_GE(left_s, 4 + hooks::extctl::kSettleSecs);
  EXPECT_LE(left_s, 4 + 3 * hooks::extctl::kSettleSecs);
  writer.tell(up, 80);
  EXPECT_EQ(of(answerOf(writer), PortSensor::WantsSurface), kSurfaceNow) << "not later";
}

/// A value on its way.
struct Passing {
  double due_s;
  int index;
  double value;
};

/// Flies random commands over a line that delays each value by up to `most_delay_s` and loses many
/// sentences, up to two in a row; returns how often the targets that had arrived contradicted each
/// other.
int contradictions(uint64_t seed, double most_delay_s) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  PortWriter writer(kCommon, true);
  std::vector<Passing> passing;
  std::map<int, double> last_due_s;  // a sensor's older value never overtakes a newer one
  std::map<int, double> arrived = {
      {static_cast<int>(PortSensor::DiveDepth), hooks::extctl::kFirstDiveDepth},
      {static_cast<int>(PortSensor::ClimbDepth), hooks::extctl::kFirstClimbDepth}};
  StockCommand command = between(5, 40);
  int wrong = 0, lost = 0;
  for (double now = 0; now < 2000; now += 4) {
    if (uniform(0, 1) < 0.05) {
      const double target = uniform(4, 55);
      const hooks::Instruction instruction{.vertical = uniform(0, 1) < 0.5
                                                           ? hooks::HookVertical::Descend
                                                           : hooks::HookVertical::Ascend,
                                           .depth_m = target};
      follow(instruction, kCommon, having(uniform(0, 60)), command);
    }
    writer.tell(command, now);
    const auto values = answerOf(writer);
    lost = now != 0 && lost < 2 && uniform(0, 1) < 0.2 ? lost + 1 : 0;
    if (lost == 0) {
      for (const auto& [index, value] : values) {
        double& due_s = last_due_s[index];
        due_s = std::max(due_s, now + uniform(1, most_delay_s));
        passing.push_back({due_s, index, value});
      }
    }
    for (const Passing& one : passing) {
      if (one.due_s <= now) {
        arrived[one.index] = one.value;
      }
    }
    std::erase_if(passing, [&](const Passing& one) { return one.due_s <= now; });
    const double dive = of(arrived, PortSensor::DiveDepth),
                 climb = of(arrived, PortSensor::ClimbDepth);
    wrong += dive <= climb ? 1 : 0;
  }
  return wrong;
}

TEST(PortWriter, NoMixtureOfOldAndNewContradictsItself) {
  int wrong = 0;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    wrong += contradictions(seed, 8);
  }
  EXPECT_EQ(wrong, 0);
}

/// What proofs assume of the port (widenForPort): a command that stays for this long is written.
TEST(PortWriter, ACommandIsHeldBackNoLongerThanItsDepthsNeedToSettle) {
  double longest_s = 0;
  for (uint64_t seed = 0; seed < 300; ++seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    PortWriter writer(kCommon, true);
    StockCommand command = between(5, 40);
    std::map<int, double> last;
    double now = 0;
    for (int number = 0; number < 40; ++number) {
      const auto vertical = uniform(0, 1) < 0.2   ? hooks::HookVertical::Surface
                            : uniform(0, 1) < 0.5 ? hooks::HookVertical::Descend
                                                  : hooks::HookVertical::Ascend;
      follow({.vertical = vertical, .depth_m = uniform(2, 60)}, kCommon, having(uniform(0, 60)),
             command);
      const double from = now, until = now + uniform(0, 90);
      for (bool there = false; now <= until; now += uniform(3, 5)) {
        writer.tell(command, now);
        for (const auto& [index, value] : answerOf(writer)) {
          last[index] = value;
        }
        // That it may go down again waits for the depths; nothing depends on it.
        const bool surfaces = !command.surface || of(last, PortSensor::WantsSurface) == kSurfaceNow;
        const auto near = [](double a, double b) { return std::fabs(a - b) < 1e-5; };
        there = there ||
                (surfaces && (command.surface ||
                              (near(of(last, PortSensor::DiveDepth), command.dive_depth_m) &&
                               near(of(last, PortSensor::ClimbDepth), command.climb_depth_m))));
        longest_s = there ? longest_s : std::max(longest_s, now - from);
      }
    }
  }
  EXPECT_LE(longest_s, hooks::extctl::kSettleSecs + 20) << "and one cycle of the longest";
  EXPECT_GT(longest_s, hooks::extctl::kSettleSecs / 2);
}

TEST(StockCommand, AClimbToLessThanAMetreIsToTheSurface) {
  StockCommand command;
  follow({.vertical = hooks::HookVertical::Ascend, .depth_m = 0.9, .pitch_rad = 0.5}, kModes, {},
         command);
  EXPECT_TRUE(command.surface) << "hookbeh does not hover there either";
  EXPECT_EQ(command.modes, static_cast<uint32_t>(kGliderPortModeSurface));
  follow({.vertical = hooks::HookVertical::Ascend, .depth_m = 1, .pitch_rad = 0.5}, kModes, {},
         command);
  EXPECT_FALSE(command.surface);
  follow({.vertical = hooks::HookVertical::Descend, .depth_m = 1.9}, kModes, {}, command);
  EXPECT_TRUE(command.surface) << "a yo above 2 m is none, and a deeper dive must not go on";
}

TEST(StockCommand, ATargetIsOneEndOfAYo) {
  StockCommand command;
  follow({.vertical = hooks::HookVertical::Descend, .depth_m = 50, .pitch_rad = -0.4}, kCommon,
         having(48), command);
  EXPECT_EQ(command.dive_depth_m, 50);
  EXPECT_EQ(command.climb_depth_m, 40);
  EXPECT_EQ(command.dive_pitch_rad, -0.4);
  EXPECT_FALSE(command.surface);
  follow({.vertical = hooks::HookVertical::Ascend, .depth_m = 12, .pitch_rad = 0.5}, kCommon,
         having(50), command);
  EXPECT_EQ(command.climb_depth_m, 12);
  EXPECT_EQ(command.dive_depth_m, 22);
  EXPECT_EQ(command.climb_pitch_rad, 0.5);
  EXPECT_EQ(command.dive_pitch_rad, -0.4) << "stays";
  follow({.vertical = hooks::HookVertical::Descend, .depth_m = 6}, kCommon, having(20), command);
  EXPECT_EQ(command.climb_depth_m, 3) << "not above the surface";
  follow({.vertical = hooks::HookVertical::Ascend, .depth_m = 55}, kCommon, having(60), command);
  EXPECT_EQ(command.dive_depth_m, 60) << "not below the greatest depth";
}

TEST(StockCommand, ADiveKeepsTheUpperEndUntilTheVehicleCanTurnBelowAnother) {
  StockCommand command;
  const hooks::Instruction deep{.vertical = hooks::HookVertical::Descend, .depth_m = 60};
  follow({.vertical = hooks::HookVertical::Ascend, .depth_m = 4}, kCommon, having(30), command);
  EXPECT_EQ(command.climb_depth_m, 4);
  for (const double deep_m : {18.0, 30.0, 54.9}) {
    follow(deep, kCommon, having(deep_m), command);
    EXPECT_EQ(command.climb_depth_m, 4) << deep_m;
  }
  follow(deep, kCommon, having(55), command);
  EXPECT_EQ(command.climb_depth_m, 50);
  follow(deep, kCommon, having(52), command);
  EXPECT_EQ(command.climb_depth_m, 42) << "the bottom has risen";
  follow(deep, kCommon, having(54), command);
  EXPECT_EQ(command.climb_depth_m, 42);
  follow(deep, kCommon, having(8), command);
  EXPECT_EQ(command.climb_depth_m, hooks::extctl::kFirstClimbDepth);
  follow(deep, kCommon, having(60), command);
  EXPECT_EQ(command.climb_depth_m, 50);
  follow({.vertical = hooks::HookVertical::Surface}, kCommon, having(60), command);
  follow(deep, kCommon, having(30), command);
  EXPECT_EQ(command.climb_depth_m, hooks::extctl::kFirstClimbDepth) << "from the surface";
}

TEST(StockCommand, AClimbToADepthAboveWhichTheVehicleIsIsADive) {
  StockCommand command;
  const hooks::Instruction to{.vertical = hooks::HookVertical::Ascend, .depth_m = 30};
  follow(to, kCommon, having(2), command);
  EXPECT_EQ(command.dive_depth_m, 40);
  EXPECT_EQ(command.climb_depth_m, hooks::extctl::kFirstClimbDepth);
  follow(to, kCommon, having(35), command);
  EXPECT_EQ(command.climb_depth_m, 30);
}

TEST(StockCommand, AWaypointIsABearingWhereTheReleaseHasNoModes) {
  const hooks::Instruction east{.vertical = hooks::HookVertical::Surface,
                                .lateral = hooks::HookLateral::Waypoint,
                                .latitude_ddmm = 0,
                                .longitude_ddmm = 130.0};
  StockCommand command;
  follow(east, kCommon, {0, 100, 0.25}, command);
  EXPECT_NEAR(command.heading_rad, 1.5708 + 0.25, 1e-3) << "from magnetic north";
  EXPECT_EQ(command.modes & kGliderPortModeWaypoint, 0U);
  follow(east, kCommon, {}, command);
  EXPECT_NEAR(command.heading_rad, 1.5708 + 0.25, 1e-3) << "an unknown place: the heading stays";
  follow(east, kModes, {0, 100, 0.25}, command);
  EXPECT_NE(command.modes & kGliderPortModeWaypoint, 0U);
  EXPECT_EQ(command.waypoint_longitude_ddmm, 130.0);
  follow({.vertical = hooks::HookVertical::Surface,
          .lateral = hooks::HookLateral::Heading,
          .heading_rad = 3},
         kModes, {}, command);
  EXPECT_EQ(command.modes, static_cast<uint32_t>(kGliderPortModeSurface));
  EXPECT_EQ(command.heading_rad, 3);
}

}  // namespace
}  // namespace glider::runtime::extctl
