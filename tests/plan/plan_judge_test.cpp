// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What `glidercc plan` chooses is the best that there is: each way to choose is written into the
// mission as constants, checked and scored by itself.

#include "analysis/check/check.h"
#include "analysis/plan/plan_mission.h"
#include "compiler/boards.h"
#include "compiler/compilation.h"
#include "ir/prove/energy/energy_bound.h"
#include "tests/plan/problems.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using analysis::CheckObserver;

/// The mission with these values as constants.
std::string settled(const Problem& problem, const std::vector<double>& values) {
  std::string text = "mission " + problem.name + "\n";
  for (size_t i = 0; i < values.size(); ++i) {
    text += fmt::format("const {}: {} = {}\n", problem.open[i].name, problem.open[i].type,
                        valueText(problem.open[i], values[i]));
  }
  return text + problem.rest;
}

std::vector<std::vector<double>> everyWay(const Problem& problem) {
  std::vector<std::vector<double>> ways{{}};
  for (const OpenValue& one : problem.open) {
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& way : ways) {
      for (int i = 0; one.lowest + i * one.step <= one.highest + one.step / 1000; ++i) {
        longer.push_back(way);
        longer.back().push_back(one.lowest + i * one.step);
      }
    }
    ways = std::move(longer);
  }
  return ways;
}

bool provesAll(const std::string& text) {
  CheckObserver silent;
  auto compiled = compiler::compileText("m.mission", text);
  EXPECT_TRUE(compiled) << text;
  const auto file = analysis::checkCompilation("m.mission", std::move(*compiled), {}, silent);
  return file.found.ok() && std::ranges::all_of(file.found.requirements, [](const auto& one) {
           return one.verdict == "proved";
         });
}

/// The energy that is compared last: until the end if there is one, else on average.
double energyOf(const std::string& text) {
  const auto compiled = compiler::compileText("m.mission", text);
  EXPECT_TRUE(compiled && compiled->checked) << text;
  const platforms::Platform& vehicle = compiled->checked->worlds.widest.platform;
  const auto board = compiler::usualBoard(vehicle);
  const auto bound = ir::prove::energyBoundOf(compiled->checked->mission(), vehicle,
                                              (**board).power, ir::prove::Parameters::AsWritten);
  EXPECT_TRUE(bound);
  return bound->joules.value_or(bound->watts);
}

/// Whether scores come first in lexicographic order, by more than rounding.
bool isBetter(const std::vector<double>& a, const std::vector<double>& b) {
  for (size_t i = 0; i < a.size(); ++i) {
    if (std::fabs(a[i] - b[i]) > 1e-9 * std::fabs(a[i])) {
      return a[i] < b[i];
    }
  }
  return false;
}

struct Judged {
  std::vector<double> values, scores;
  size_t proved = 0, ways = 0;
};

Judged tryEverything(const Problem& problem) {
  Judged best;
  for (const std::vector<double>& way : everyWay(problem)) {
    ++best.ways;
    const std::string text = settled(problem, way);
    if (!problem.allowed(way) || !provesAll(text)) {
      continue;
    }
    ++best.proved;
    std::vector<double> scores = problem.scores(way);
    scores.push_back(energyOf(text));
    if (best.values.empty() || isBetter(scores, best.scores)) {
      best.values = way;
      best.scores = scores;
    }
  }
  return best;
}

class PlanJudge : public ::testing::TestWithParam<Problem> {};

TEST_P(PlanJudge, NothingIsBetter) {
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  const Problem& problem = GetParam();
  const Judged best = tryEverything(problem);
  ASSERT_GT(best.proved, 0);
  EXPECT_LT(problem.scores(best.values).empty() ? 0 : best.proved, best.ways)
      << "a problem where everything is proved";
  const auto compiled = compiler::compileText("m.mission", openText(problem));
  ASSERT_TRUE(compiled && compiled->checked) << openText(problem);
  CheckObserver silent;
  const auto planned = analysis::planMission("m.mission", *compiled, {}, silent);
  ASSERT_TRUE(planned && planned->plan.chosen) << openText(problem);
  EXPECT_EQ(planned->plan.ways, best.ways);
  std::vector<std::string> expected;
  for (size_t i = 0; i < best.values.size(); ++i) {
    expected.push_back(valueText(problem.open[i], best.values[i]));
  }
  EXPECT_EQ(planned->plan.chosen->values, expected);
  // What it wrote is the mission that was checked.
  EXPECT_TRUE(provesAll(planned->text)) << planned->text;
  std::vector<double> scores = problem.scores(best.values);
  EXPECT_NEAR(energyOf(planned->text), best.scores.back(), 1e-9 * best.scores.back());
}

INSTANTIATE_TEST_SUITE_P(Problems, PlanJudge, testing::ValuesIn(planProblems()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace glider::tests
