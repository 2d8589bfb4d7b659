// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What instruments take that a mission switches: bounds by hand, and flights that keep to them.

#include "compiler/compilation.h"
#include "ir/prove/energy/energy_bound.h"
#include "ir/prove/falsification/rng.h"
#include "tests/energy/watched_energy.h"
#include "tests/world/fleet.h"
#include "tests/world/random_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

namespace glider::tests {
namespace {

using ir::prove::EnergyBound;
using ir::prove::Parameters;
using ir::prove::Rng;

EnergyBound sampledBound(const std::string& text, Parameters parameters = Parameters::AsWritten) {
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  const auto compiled = compiler::compileText("test.mission", "mission test\n" + text);
  EXPECT_TRUE(compiled && compiled->checked) << text;
  const auto bound =
      ir::prove::energyBoundOf(compiled->checked->mission(), slocum(), std::nullopt, parameters);
  EXPECT_TRUE(bound) << text;
  return bound.value_or(EnergyBound{});
}

/// A mission of one state for two hours; `sample` is a line of it, or nothing.
std::string alone(const std::string& sample, const std::string& sensors = "depth, temp") {
  return fmt::format(
      "param often : time = 60 s in 20 s .. 60 s\nstate one\nbegin\n  flightprofile yo(5 m, 50 m)\n"
      "  sensors missiontime, m_depth_state, {}\n{}  events\n    case missiontime > 2 h "
      "exit\nend\n",
      sensors, sample.empty() ? "" : "  sample " + sample + "\n");
}

/// The most that an instrument takes while it is on, W.
double fullPower(const std::string& device) {
  for (const platforms::Draw& draw : slocum().power.draws) {
    if (draw.device == device) {
      return draw.amount * (1 + draw.spread);
    }
  }
  return 0;
}

/// How much more than `alone("")` takes on average, W.
double moreWatts(const std::string& sample, const std::string& sensors = "depth, temp",
                 Parameters parameters = Parameters::AsWritten) {
  return sampledBound(alone(sample, sensors), parameters).states.front().watts -
         sampledBound(alone("", sensors), parameters).states.front().watts;
}

TEST(SampledEnergy, OneThatIsOffTakesNothing) {
  EXPECT_NEAR(moreWatts("ctd off"), -fullPower("ctd"), 1e-4);
  EXPECT_NEAR(moreWatts("optode off", "oxygen"), -fullPower("optode"), 1e-4);
  EXPECT_NEAR(moreWatts("optode off"), 0, 1e-4) << "the mission does not read it";
}

TEST(SampledEnergy, OneThatReadsNowAndThenIsOnForItsReadings) {
  EXPECT_NEAR(moreWatts("ctd every 40 s"), -0.9 * fullPower("ctd"), 1e-4);
  EXPECT_NEAR(moreWatts("ctd every 2 s"), 0, 1e-4);
  EXPECT_NEAR(moreWatts("fluorometer every 50 s"), 0.1 * fullPower("fluorometer"), 1e-4)
      << "for the vehicle's own log";
  EXPECT_NEAR(moreWatts("fluorometer, optode"), fullPower("fluorometer") + fullPower("optode"),
              1e-4);
}

TEST(SampledEnergy, AConditionMayAlwaysBeTrue) {
  EXPECT_NEAR(moreWatts("ctd every 40 s when climbing"), -0.9 * fullPower("ctd"), 1e-4);
  EXPECT_NEAR(moreWatts("ctd off when climbing"), 0, 1e-4) << "else it reads as the vehicle says";
  EXPECT_NEAR(moreWatts("fluorometer when depth > 20 m"), fullPower("fluorometer"), 1e-4);
}

TEST(SampledEnergy, AParameterMayHaveItsLowestValue) {
  EXPECT_NEAR(moreWatts("ctd every often"), (4.0 / 60 - 1) * fullPower("ctd"), 1e-4);
  EXPECT_NEAR(moreWatts("ctd every often", "depth", Parameters::Any),
              (4.0 / 20 - 1) * fullPower("ctd"), 1e-4);
}

/// A reading may be unknown, and then it reads as often as it can.
TEST(SampledEnergy, ATimeThatMayBeUnknownIsTheShortest) {
  EXPECT_NEAR(moreWatts("ctd every 20 s + temp * 1 s / 1 degC"), 0, 1e-4);
}

/// What a state commands is in force until the vehicle obeys the next.
TEST(SampledEnergy, TheStateBeforeGoesOnForAMoment) {
  const auto text = [](const std::string& second) {
    return "state one\nbegin\n  flightprofile yo(5 m, 50 m)\n  sensors missiontime\n  sample "
           "fluorometer\n"
           "  events\n    case missiontime > 1 h goto two\nend\n"
           "state two\nbegin\n  flightprofile yo(5 m, 50 m)\n  sensors missiontime\n" +
           second + "  events\n    case missiontime > 2 h exit\nend\n";
  };
  const double on = *sampledBound(text("  sample fluorometer\n")).joules;
  const double off = *sampledBound(text("  sample fluorometer off\n")).joules;
  const double lag_s = (on - off) / fullPower("fluorometer");
  EXPECT_LT(lag_s, 3570);
  EXPECT_GT(lag_s, 3480);
  EXPECT_NEAR(*sampledBound(text("")).joules, off, 1e-3)
      << "the vehicle's own mission does not read it";
}

TEST(SampledEnergy, BeforeTheFirstCommandItReadsAsTheVehicleSays) {
  const auto secondsOn = [](const std::string& device) {
    return (*sampledBound(alone(device)).joules - *sampledBound(alone(device + " off")).joules) /
           fullPower(device);
  };
  // The mission reads what the CTD measures, and nothing of the fluorometer.
  EXPECT_NEAR(secondsOn("fluorometer") - secondsOn("ctd"), 40, 1);
}

/// A vehicle that never rests reads as well.
TEST(SampledEnergy, OneThatIsOnCountsWhereThePumpHardlyRests) {
  const auto watts = [](const std::string& sample) {
    return sampledBound(
               "var middle: length = 40 m in 20 m .. 60 m\nstate one\nbegin\n"
               "  flightprofile yo(middle - 15 m, middle + 15 m)\n  sensors missiontime, depth\n" +
               sample +
               "  events\n    case depth > 30 m do set middle = clamp(depth, 20 m, 60 m) end stay\n"
               "    case missiontime > 2 h exit\nend\n")
        .watts;
  };
  EXPECT_NEAR(watts("  sample fluorometer\n") - watts(""), fullPower("fluorometer"), 0.01);
}

/// What is always drawn counts no instrument that is off somewhere.
TEST(SampledEnergy, TheLeastIsThatOfInstrumentsThatAreNotSwitched) {
  const EnergyBound usual = sampledBound(alone("")), off = sampledBound(alone("ctd off"));
  ASSERT_TRUE(usual.earliest_s && off.earliest_s);
  const double ctd_W = 0.13 * (1 - 0.15);
  EXPECT_NEAR(usual.least_j - off.least_j, ctd_W * *usual.earliest_s, 1);
}

/// A random mission with lines `sample`.
std::string sampled(const std::string& text, Rng& dice) {
  static constexpr std::array kLines = {"ctd off",
                                        "ctd every 30 s, fluorometer",
                                        "fluorometer every 20 s when climbing",
                                        "optode when depth > 10 m, ctd every 60 s when diving",
                                        "fluorometer, optode, ctd",
                                        "ctd off when climbing",
                                        "fluorometer off, optode every 120 s"};
  std::string out;
  size_t at = 0;
  const std::string word = "\n  flightprofile";  // of a state
  for (size_t found = text.find(word); found != std::string::npos; found = text.find(word, at)) {
    const size_t end = text.find('\n', found + 1);
    out += text.substr(at, end + 1 - at);
    at = end + 1;
    if (dice.chance(0.7)) {
      out += std::string("  sample ") + kLines.at(dice.below(kLines.size())) + "\n";
    }
  }
  return out + text.substr(at);
}

TEST(SampledEnergy, NoFlightTakesMore) {
  constexpr uint64_t kFew = 10;
  const uint64_t count = wanted("GLIDER_ENERGY_FLIGHTS", kFew);
  const uint64_t seed = wanted("GLIDER_ENERGY_SEED", 1);
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  const std::vector<simulator::Scenario> seas = scenarios();
  uint64_t in_control = 0;
  for (uint64_t i = seed; i < seed + count; ++i) {
    Rng dice(i);
    const std::string text = sampled(randomMissionText(i), dice);
    ASSERT_TRUE(compiler::compileText("sampled", text)->checked) << text;
    const auto mission = loadMission(fmt::format("sampled {}", i), text);
    ASSERT_TRUE(mission) << text;
    const auto bound = boundOfEnergy(*mission, slocum(), usualBoardPower());
    ASSERT_TRUE(bound) << text;
    const auto sea = drawSea(seas[i % seas.size()], *bound, dice);
    const FlownEnergy flown = flyForEnergy(*mission, *bound, sea, i);
    in_control += flown.seconds > 0;
    EXPECT_LE(flown.nearest, 1) << "flight " << i << " in " << sea.name << "\n" << text;
  }
  EXPECT_GT(in_control, count / 2);
}

}  // namespace
}  // namespace glider::tests
