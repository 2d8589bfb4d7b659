// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a mission that lets its SBC sleep changes in proofs and bounds.

#include "ir/worlds/naps.h"

#include "analysis/brief/summary.h"
#include "compiler/compilation.h"
#include "compiler/proving.h"
#include "ir/prove/energy/energy_bound.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::compiler {
namespace {

constexpr const char* kNap = "nap at most 4 min";

/// A dive whose end only the clock gives, and so the time until that is obeyed.
std::string diveOfAMinute(const std::string& line, double limit_m) {
  return fmt::format(R"(mission m
{}
assume no outage
require always depth <= {} m

state down
begin
  flightprofile yo(5 m, 90 m, 26 deg, 26 deg)
  sensors       statetime, depth
  events
    case statetime >= 60 s goto up
end

state up
begin
  flightprofile surfaced
  sensors       statetime, depth
  events
    case statetime >= 90 min exit
end
)",
                     line, limit_m);
}

std::shared_ptr<const Checked> checkedOf(const std::string& text) {
  const auto compiled = compileText("m.mission", text);
  EXPECT_TRUE(compiled && compiled->checked) << text;
  return compiled->checked;
}

ir::prove::Verdict verdict(const std::string& line, double limit_m) {
  support::DiagnosticEngine unheard;
  return prove(*checkedOf(diveOfAMinute(line, limit_m)), {}, unheard).requirements.at(0).verdict;
}

TEST(Naps, DelayEachCommandByTheTimeToWakeAndToRead) {
  const auto delay = [](const std::string& line) {
    return checkedOf(diveOfAMinute(line, 95))->worlds.assumed.platform.world.command_delay_s;
  };
  EXPECT_EQ(ir::kNapLag_s, 15);
  EXPECT_EQ(delay(""), 0);
  EXPECT_EQ(delay(kNap), 15);
}

/// The least limit of the depth that is proved, m.
double leastProved(const std::string& line) {
  double refused = 20, proved = 95;
  while (proved - refused > 0.05) {
    const double middle = (proved + refused) / 2;
    (verdict(line, middle) == ir::prove::Verdict::Proved ? proved : refused) = middle;
  }
  return proved;
}

/// The dive that the clock ends goes on for 15 s more, at 0.4 m/s.
TEST(Naps, ProofsCountWithTheDelay) {
  EXPECT_NEAR(leastProved(kNap), leastProved("") + 15 * 0.4, 0.2);
}

ir::prove::EnergyBound energyOf(const std::string& line, const platforms::BoardPower& board) {
  const auto checked = checkedOf(diveOfAMinute(line, 95));
  const auto bound = ir::prove::energyBoundOf(checked->mission(), checked->platform(), board,
                                              ir::prove::Parameters::AsWritten);
  EXPECT_TRUE(bound);
  return bound.value_or(ir::prove::EnergyBound{});
}

/// An SBC that may sleep all the time takes what it takes asleep, if that is known.
TEST(Naps, TheLeastEnergyDoesNotCountASleepingSbc) {
  constexpr double kEnd_s = 60 + 90 * 60;
  const platforms::BoardPower none, board{2, 0.5, "", {}};
  platforms::BoardPower sleeps = board;
  sleeps.sleep = platforms::BoardSleep{0.5, 2};
  const double rest_j = energyOf("", none).least_j;
  const auto of_board = [&](const std::string& line, const platforms::BoardPower& power) {
    const auto bound = energyOf(line, power);
    return (bound.least_j - rest_j) / bound.earliest_s.value_or(0);
  };
  EXPECT_GE(energyOf("", none).earliest_s.value_or(0), kEnd_s);
  EXPECT_NEAR(of_board("", board), 1, 1e-9);
  EXPECT_NEAR(of_board("", sleeps), 1, 1e-9);
  EXPECT_NEAR(of_board(kNap, board), 0, 1e-9);
  EXPECT_NEAR(of_board(kNap, sleeps), 0.25, 1e-9);
}

/// The most is with an SBC that never sleeps, and with a dive that leaves the surface later. Where
/// the vehicle turns it does not wait for its commands.
TEST(Naps, TheMostEnergyIsHardlyMore) {
  const platforms::BoardPower board{2, 0.5, "", {}};
  const double most_j = energyOf("", board).joules.value_or(1e9);
  EXPECT_GE(energyOf(kNap, board).joules.value_or(0), most_j);
  EXPECT_LT(energyOf(kNap, board).joules.value_or(0), most_j * 1.02);
}

TEST(Naps, TheVehicleWakesTheSbcBeforeADepthIsReached) {
  // 0.4 m/s for two ticks 20 s apart and the 15 s until the SBC acts; readings wrong by 0.9 m.
  EXPECT_NEAR(ir::napAhead_m(checkedOf(diveOfAMinute(kNap, 95))->platform()), 15.8, 1e-9);
}

TEST(Naps, TheBriefNamesThem) {
  const auto checked = checkedOf(diveOfAMinute(kNap, 95));
  EXPECT_THAT(analysis::summaryOf(*checked, {}, nullptr, 95),
              testing::Contains(testing::HasSubstr("sleeps for up to 4 min 0 s at a time")));
  EXPECT_THAT(analysis::assumptionsOf(checked->platform(), checked->mission()),
              testing::HasSubstr("A command takes effect within 27 s."));
}

}  // namespace
}  // namespace glider::compiler
