// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The values that are tried, and the front of those that none beats.

#include "analysis/plan/grid.h"

#include "analysis/plan/front.h"
#include "support/units/units.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using analysis::PlanGrid;
using analysis::ScoredPlan;
using testing::ElementsAre;

frontend::OpenChoice choice(const std::string& unit, double lowest, double highest, double step) {
  const support::Unit of = support::findUnit(unit).value_or(support::Unit{"", {}, 1});
  frontend::OpenChoice made;
  made.name = "a";
  made.type = {ir::TypeKind::Quantity, of.dimension};
  made.unit = unit;
  made.lowest = lowest * of.to_si;
  made.highest = highest * of.to_si;
  made.step = step * of.to_si;
  return made;
}

std::vector<std::string> textsOf(const frontend::OpenChoice& one) {
  const PlanGrid grid({{one}});
  std::vector<std::string> texts;
  for (size_t i = 0; i < static_cast<size_t>(grid.count()); ++i) {
    texts.push_back(compiler::textOf(grid.at(i).front()));
  }
  return texts;
}

TEST(PlanGrid, GoesByTheStepInTheUnitOfTheText) {
  EXPECT_THAT(textsOf(choice("m", 60, 180, 50)), ElementsAre("60 m", "110 m", "160 m"));
  EXPECT_THAT(textsOf(choice("h", 1, 2, 0.25)),
              ElementsAre("1 h", "1.25 h", "1.5 h", "1.75 h", "2 h"));
  // Rounding adds nothing, and loses nothing.
  EXPECT_THAT(textsOf(choice("deg", 0.1, 0.3, 0.1)), ElementsAre("0.1 deg", "0.2 deg", "0.3 deg"));
}

TEST(PlanGrid, TriesRoundNumbersBetweenTheEnds) {
  const auto texts = textsOf(choice("m", 12, 98.5, 0));
  EXPECT_EQ(texts.front(), "12 m");
  EXPECT_EQ(texts[1], "15 m");
  EXPECT_EQ(texts[2], "20 m");
  EXPECT_EQ(texts.back(), "98.5 m");
  EXPECT_EQ(texts.size(), 19);
  EXPECT_THAT(textsOf(choice("m", 7, 7, 0)), ElementsAre("7 m"));
  EXPECT_THAT(textsOf(choice("m", -2, -1.9, 0)), testing::SizeIs(testing::Le(25)));
}

TEST(PlanGrid, HasEveryWayOnce) {
  const PlanGrid grid({{choice("m", 1, 3, 1), choice("h", 1, 2, 1), choice("", 0, 3, 1)}});
  ASSERT_EQ(grid.count(), 24);
  std::set<std::string> ways;
  for (size_t i = 0; i < 24; ++i) {
    std::string way;
    for (const auto& one : grid.at(i)) {
      way += compiler::textOf(one) + ";";
    }
    ways.insert(way);
  }
  EXPECT_EQ(ways.size(), 24);
  EXPECT_EQ(compiler::textOf(grid.at(0)[2]), "0");
  EXPECT_EQ(compiler::textOf(grid.at(1)[2]), "1");
}

/// Pareto by the definition: no other is at least as good in all and better in one; of equal ones
/// the first.
std::vector<size_t> frontByDefinition(const std::vector<ScoredPlan>& plans) {
  std::vector<size_t> front;
  for (size_t i = 0; i < plans.size(); ++i) {
    bool beaten = false;
    for (size_t k = 0; k < plans.size() && !beaten; ++k) {
      bool no_worse = true, better = false;
      for (size_t s = 0; s < plans[i].scores.size(); ++s) {
        no_worse = no_worse && plans[k].scores[s] <= plans[i].scores[s];
        better = better || plans[k].scores[s] < plans[i].scores[s];
      }
      beaten = no_worse && (better || k < i);
    }
    if (!beaten) {
      front.push_back(plans[i].number);
    }
  }
  return front;
}

TEST(PlanFront, IsThatOfTheDefinition) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    std::vector<ScoredPlan> plans(random() % 40);
    const size_t objectives = 1 + random() % 4;
    for (size_t i = 0; i < plans.size(); ++i) {
      plans[i].number = i;
      for (size_t s = 0; s < objectives; ++s) {
        plans[i].scores.push_back(static_cast<double>(random() % 6));
      }
    }
    std::ranges::stable_sort(plans, {}, &ScoredPlan::scores);
    std::vector<size_t> numbers;
    for (const ScoredPlan& one : analysis::frontOf(plans)) {
      numbers.push_back(one.number);
    }
    EXPECT_EQ(numbers, frontByDefinition(plans)) << "round " << round;
  }
}

}  // namespace
}  // namespace glider::tests
