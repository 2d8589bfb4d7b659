// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Each fault that can be planted in the code of a small mission, which has one of each kind of
// construct: the comparison finds all but those that change nothing.

#include "compiler/compilation.h"
#include "tests/validate/built.h"
#include "tests/validate/faults.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <regex>
#include <string>
#include <vector>

namespace glider::validate_test {
namespace {

constexpr const char* kMission = R"(mission every_fault

const home = 39 10.5 N 73 49.8 W
param deepest: length = 40 m in 20 m .. 60 m

var seen: bool = false
var times: number = 0 in 0 .. 9
var sum: number = 0

always
  case seen && distance(home) > 2 km do set seen = false end stay

state out
begin
  flightroute   heading(90 deg)
  flightprofile yo(5 m, deepest, 26 deg, 26 deg)
  sensors       depth, temp, missiontime
  events
    case held(temp < 12 degC, 20 s) do
      set seen = true
      set times = clamp(times + 1, 0, 9)
      set sum = sum + sqrt(depth / 1 m) / 3
      log "cold", temp, sum
    end call back
    case mean(temp, 2 min) - temp > 1 degC && depth > 30 m call back
    case missiontime > 2 h || times >= 8 exit
end

state back
begin
  flightroute   nav(home)
  flightprofile yo(5 m, 30 m, 26 deg, 26 deg)
  sensors       depth, temp
  events
    case statetime > 10 min && !(temp < 9 degC) return
end
)";

/// Without the numbers of values, which depend on all that comes before.
std::string withoutNumbers(const std::string& words) {
  static const std::regex kNumber("%[0-9]+");
  return std::regex_replace(words, kNumber, "%");
}

/// What a fault changes there cannot happen, or is overwritten: a clamp takes either bound where
/// both are equal, time after the start of a window is exactly 0, `unless` of a known truth.
bool changesNothing(const std::string& words) {
  constexpr const char* kHarmless[] = {
      "act.out: a comparison that differs where both are equal instead of  % = fcmp ogt double %, "
      "9.000000e+00",
      "act.out: a comparison that differs where both are equal instead of  % = fcmp olt double %, "
      "0.000000e+00",
      "% = fcmp ole double %, 6.000000e+00", "enter.back: "};
  return std::ranges::any_of(kHarmless,
                             [&](const char* one) { return withoutNumbers(words).contains(one); });
}

/// A share of them, by GLIDER_FAULTS_STEP and from GLIDER_FAULTS_FIRST on: all take minutes
/// (scripts/soak/validate).
TEST(EveryFault, OfASmallMissionIsFound) {
  const auto compilation = compiler::compileText("every_fault.mission", kMission);
  ASSERT_TRUE(compilation && compilation->checked);
  const compiler::Optimised mission = compiler::optimise(compilation->checked);
  ASSERT_EQ(whatIsNotSame(validate(mission.input(), "host", 2)), "");
  size_t count = 1;
  std::vector<std::string> missed;
  const uint64_t step = setting("GLIDER_FAULTS_STEP", 9);
  for (size_t number = setting("GLIDER_FAULTS_FIRST", 0); number < count; number += step) {
    std::string words;
    const auto found = validate(mission.input(), "host", 2, {}, [&](llvm::Module& module) {
      count = faultsIn(module);
      words = plantFault(module, number % count);
    });
    if (whatIsNotSame(found).empty() && !changesNothing(words)) {
      missed.push_back(words);
    }
  }
  EXPECT_GT(count, 300U);
  EXPECT_THAT(missed, testing::ElementsAre());
}

}  // namespace
}  // namespace glider::validate_test
