// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Thresholds at the limit of what is known: the equal one is proved, the next double is not.

#include "ir/eval/arithmetic.h"
#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "ir/worlds/under_assumptions.h"
#include "tests/proofs/properties.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace glider::tests {
namespace {

using ir::prove::Verdict;

/// The verdicts on the requirements of a mission.
std::vector<ir::prove::RequirementVerdict> judgedLimits(const std::string& text) {
  frontend::testing_support::FrontendRun run(text);
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said() << text;
  if (!mission) {
    return {};
  }
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  EXPECT_FALSE(run.diagnostics.hasErrors()) << run.said();
  ir::prove::Options how;
  how.random_ticks = 2000;
  return ir::prove::prove(*mission, facts, slocum(), how, run.diagnostics).requirements;
}

bool isProved(const std::string& text) {
  const auto all = judgedLimits(text);
  return all.size() == 1 && all.front().verdict == Verdict::Proved;
}

/// Seventeen digits name a double.
std::string digits(double value) {
  return fmt::format("{:.17g}", value);
}

double above(double value) {
  return std::nextafter(value, 1e9);
}

double below(double value) {
  return std::nextafter(value, -1e9);
}

// --- Assumed ranges

std::string reads(const std::string& sensor, const std::string& assumption,
                  const std::string& requirement) {
  return fmt::format(
      "mission m\nassume {}\nrequire always !known({}) || {}\nstate a\nbegin\n"
      "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n  sensors missiontime, {}\n  events\n"
      "    case missiontime >= 30 min exit\nend\n",
      assumption, sensor, requirement, sensor);
}

struct Range {
  const char* sensor;
  double lowest, highest;
  const char* unit;
};

/// Whether the sensor, assumed to be in the range, is proved to be within the limit.
bool holdsFor(const Range& r, const char* relation, double limit) {
  const std::string range = fmt::format("{} in {} {} .. {} {}", r.sensor, digits(r.lowest), r.unit,
                                        digits(r.highest), r.unit);
  return isProved(reads(r.sensor, range,
                        fmt::format("{} {} {} {}", r.sensor, relation, digits(limit), r.unit)));
}

/// In the units that numbers have in proofs.
TEST(AssumedLimits, AreProvedAndTheNextDoubleIsNot) {
  for (const Range& r : {Range{"temp", 2, 28, "degC"}, Range{"temp", -1.3, 0.7, "degC"},
                         Range{"altitude", 5, 99.3, "m"}, Range{"speed", 0.1, 0.7, "m/s"}}) {
    SCOPED_TRACE(r.sensor);
    EXPECT_TRUE(holdsFor(r, "<=", r.highest));
    EXPECT_TRUE(holdsFor(r, "<", above(r.highest)));
    EXPECT_FALSE(holdsFor(r, "<", r.highest));
    EXPECT_FALSE(holdsFor(r, "<=", below(r.highest)));
    EXPECT_TRUE(holdsFor(r, ">=", r.lowest));
    EXPECT_FALSE(holdsFor(r, ">", r.lowest));
    EXPECT_FALSE(holdsFor(r, ">=", above(r.lowest)));
  }
}

/// Both the vehicle's unit and the mission's are converted.
TEST(AssumedLimits, OfConvertedUnitsAreProvedAndNothingStricter) {
  for (const Range& r : {Range{"waterdepth", 30, 7130, "cm"}, Range{"charge", 0.7, 500.1, "Ah"},
                         Range{"roll", -26, 26, "deg"}, Range{"altitude", 70, 1110, "cm"},
                         Range{"battery", 11.1, 15.3, "V"}}) {
    SCOPED_TRACE(r.sensor);
    EXPECT_TRUE(holdsFor(r, "<=", r.highest));
    EXPECT_TRUE(holdsFor(r, ">=", r.lowest));
    EXPECT_FALSE(holdsFor(r, "<", r.highest));
    EXPECT_FALSE(holdsFor(r, ">", r.lowest));
  }
}

TEST(AssumedLimits, HoldInAnotherUnit) {
  const auto holdsFor = [](const std::string& assumption, const std::string& requirement) {
    return isProved(reads("altitude", assumption, requirement));
  };
  EXPECT_TRUE(holdsFor("altitude in 5 m .. 70 m", "altitude <= 7000 cm"));
  EXPECT_TRUE(holdsFor("altitude in 5 m .. 70 m", "altitude >= 0.005 km"));
  EXPECT_TRUE(holdsFor("altitude in 0.7 m .. 70 m", "altitude >= 70 cm"))
      << "both are the nearest double";
  EXPECT_TRUE(holdsFor("altitude in 70 cm .. 70 m", "altitude >= 0.7 m"));
  EXPECT_TRUE(holdsFor("altitude in 1.1 m .. 70 m", "altitude >= 1100 mm"));
}

TEST(AssumedLimits, OfOneValueLeaveIt) {
  EXPECT_TRUE(isProved(reads("temp", "temp in 28 degC .. 28 degC", "temp == 28 degC")));
}

TEST(AssumedLimits, OfAConditionAreThoseOfARange) {
  EXPECT_TRUE(isProved(reads("temp", "temp <= 28 degC", "temp <= 28 degC")));
  EXPECT_TRUE(isProved(reads("temp", "temp < 28 degC", "temp < 28 degC")));
  EXPECT_FALSE(isProved(reads("temp", "temp <= 28 degC", "temp < 28 degC")));
}

TEST(Limits, OfThePlatformAreProvedAndNothingNarrower) {
  const auto holdsFor = [](const std::string& requirement) {
    return isProved(reads("temp", "current <= 0.5 m/s", requirement));
  };
  EXPECT_TRUE(holdsFor("temp <= 45 degC"));
  EXPECT_TRUE(holdsFor("temp >= -5 degC"));
  EXPECT_FALSE(holdsFor("temp < 45 degC"));
  EXPECT_FALSE(holdsFor("temp <= " + digits(below(45)) + " degC"));
}

/// The narrowed range holdsFor exactly the numbers of the vehicle whose reading is in the assumed
/// one.
TEST(AssumedLimits, NarrowTheVehiclesNumbersToTheLastDouble) {
  constexpr unsigned kCases = 20000;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> value(-1000, 1000);
  const double factors[] = {1, 1e5, 1e4, 3600, 0.01, 0.017453292519943295, 0.3048, 1852.0 / 3600};
  for (unsigned i = 0; i < kCases; ++i) {
    ir::Mission mission;
    ir::Sensor sensor;
    sensor.to_si = factors[i % std::size(factors)];
    sensor.lowest = -1e9;
    sensor.highest = 1e9;
    mission.sensors.push_back(sensor);
    ir::Assumption range;
    range.kind = ir::AssumptionKind::Range;
    range.sensor = {0};
    range.lowest = value(random);
    range.highest = range.lowest + std::fabs(value(random));
    mission.assumptions.push_back(range);
    const ir::Sensor narrowed = ir::underAssumptions(mission).sensors[0];
    const auto reading = [&](double raw) { return ir::reading(sensor, raw, 0); };
    ASSERT_GE(reading(narrowed.lowest), range.lowest) << i;
    ASSERT_LT(reading(below(narrowed.lowest)), range.lowest) << i;
    ASSERT_LE(reading(narrowed.highest), range.highest) << i;
    ASSERT_GT(reading(above(narrowed.highest)), range.highest) << i;
  }
}

// --- Depths that parameters and variables command

std::string dives(const std::string& head, const std::string& profile,
                  const std::string& requirement, const std::string& more = "") {
  return fmt::format(
      "mission m\nresume within 20 s\n{}\nrequire always {}\nstate track\nbegin\n  flightprofile "
      "{}\n"
      "  sensors missiontime, depth, temp\n  events\n{}"
      "    case missiontime >= 6 h exit\nend\n",
      head, requirement, profile, more);
}

const std::string kDeepest = "param deepest : length = 60 m in 30 m .. 80 m";
const std::string kYo = "yo(5 m, deepest, 26 deg, 26 deg)";

TEST(CommandedDepth, OfAParameterIsBoundedByIt) {
  EXPECT_TRUE(isProved(dives(kDeepest, kYo, "depth <= deepest + 5 m")));
  EXPECT_TRUE(isProved(dives(kDeepest, kYo, "depth - 5 m <= deepest")));
  EXPECT_TRUE(isProved(dives(kDeepest, kYo, "deepest + 5 m >= depth")));
  EXPECT_TRUE(isProved(dives(kDeepest, kYo, "depth <= max(deepest, 50 m) + 5 m")));
  EXPECT_FALSE(isProved(dives(kDeepest, kYo, "depth <= deepest")));
  EXPECT_FALSE(isProved(dives(kDeepest, kYo, "depth < deepest + 5 m")));
  EXPECT_FALSE(isProved(dives(kDeepest, kYo, "depth <= deepest + " + digits(below(5)) + " m")));
}

TEST(CommandedDepth, OfTwoParametersIsBoundedByThem) {
  const std::string two =
      "param middle : length = 40 m in 30 m .. 60 m\nparam half : length = 10 m in 5 m .. 20 m";
  EXPECT_TRUE(
      isProved(dives(two, "yo(middle - half, middle, 26 deg, 26 deg)", "depth <= middle + 5 m")));
  // A sum of three is rounded twice.
  EXPECT_FALSE(isProved(
      dives(two, "yo(5 m, middle + half, 26 deg, 26 deg)", "depth <= middle + half + 5 m")));
  EXPECT_TRUE(isProved(
      dives(two, "yo(5 m, middle + half, 26 deg, 26 deg)", "depth <= middle + half + 5.01 m")));
  EXPECT_FALSE(
      isProved(dives(two, "yo(5 m, middle + half, 26 deg, 26 deg)", "depth <= middle + 5 m")));
}

TEST(CommandedDepth, OfAVariableThatGrowsIsBoundedByIt) {
  const std::string held = "var deepest : length = 30 m in 30 m .. 80 m";
  EXPECT_TRUE(isProved(dives(held, kYo, "depth <= deepest + 5 m",
                             "    case temp > 20 degC do set deepest = 60 m end stay\n")));
  EXPECT_TRUE(isProved(dives(
      held, kYo, "depth <= deepest + 5 m",
      "    case became(temp > 20 degC) do set deepest = min(deepest + 10 m, 80 m) end stay\n")));
  EXPECT_FALSE(isProved(dives(
      "var deepest : length = 60 m in 30 m .. 80 m", kYo, "depth <= deepest + 5 m",
      "    case became(temp > 20 degC) do set deepest = max(deepest - 10 m, 30 m) end stay\n")))
      << "the vehicle is still as deep as before";
}

}  // namespace
}  // namespace glider::tests
