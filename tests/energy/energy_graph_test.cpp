// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The walks of energy graphs against a second method: what can be used up to each whole second.

#include "ir/prove/energy/energy_lines.h"
#include "ir/prove/energy/greatest_walk.h"
#include "ir/prove/falsification/rng.h"
#include "tests/slocum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace glider::tests {
namespace {

using ir::prove::EnergyArc;
using ir::prove::EnergyGraph;
using ir::prove::EnergyUse;
using ir::prove::Rng;

/// Of the pump alone.
double joules(const EnergyUse& use) {
  return use.pump_out_j;
}

EnergyUse use(double seconds, double joules) {
  EnergyUse made;
  made.seconds = seconds;  // and takes no power by itself
  made.pump_out_j = joules;
  return made;
}

/// Arcs that take whole seconds.
std::vector<EnergyArc> drawArcs(size_t vertices, Rng& dice) {
  std::vector<EnergyArc> arcs;
  const uint64_t count = vertices + dice.below(2 * vertices);
  for (uint64_t i = 0; i < count; ++i) {
    EnergyArc arc{dice.below(vertices), dice.below(vertices), {}};
    for (uint64_t k = 0; k <= dice.below(3); ++k) {
      arc.uses.push_back(
          use(static_cast<double>(1 + dice.below(9)), static_cast<double>(dice.below(50))));
    }
    arcs.push_back(std::move(arc));
  }
  return arcs;
}

/// The most that a walk of exactly t seconds takes, for each t up to `seconds`; negative: none.
std::vector<double> mostBySecond(size_t vertices, const std::vector<EnergyArc>& arcs,
                                 size_t seconds) {
  constexpr double kNone = -1e9;
  std::vector<std::vector<double>> best(seconds + 1, std::vector<double>(vertices, kNone));
  best[0][0] = 0;
  std::vector<double> most(seconds + 1, kNone);
  for (size_t t = 0; t <= seconds; ++t) {
    most[t] = std::ranges::max(best[t]);
    for (const EnergyArc& arc : arcs) {
      for (const EnergyUse& one : arc.uses) {
        const size_t then = t + static_cast<size_t>(one.seconds);
        if (then <= seconds) {
          best[then][arc.to] = std::max(best[then][arc.to], best[t][arc.from] + joules(one));
        }
      }
    }
  }
  return most;
}

TEST(EnergyGraph, BoundsEachWalkAndIsReachedInTheLongRun) {
  constexpr size_t kLong = 3000;
  size_t with_cycle = 0;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Rng dice(seed);
    const size_t vertices = 2 + dice.below(6);
    const std::vector<EnergyArc> arcs = drawArcs(vertices, dice);
    const EnergyGraph graph(vertices, arcs, joules);
    const std::vector<double> most = mostBySecond(vertices, arcs, kLong);
    for (const double dearer : {1.0001, 1.5, 4.0}) {
      const double power = graph.costliestPower() * dearer + 1e-6;
      const EnergyUse walk = graph.greatestWalk(power);
      const double offset = joules(walk) - power * walk.seconds;
      double nearest = -1e9;
      for (size_t t = 0; t <= kLong; ++t) {
        const double above = most[t] - power * static_cast<double>(t);
        EXPECT_LE(above, offset + 1e-6) << "seed " << seed << ", " << t << " s";
        nearest = std::max(nearest, above);
      }
      EXPECT_NEAR(nearest, offset, 1e-6) << "seed " << seed;
    }
    if (graph.costliestCycle().seconds > 0) {
      ++with_cycle;
      double last = 0;
      for (size_t t = kLong - 100; t <= kLong; ++t) {
        last = std::max(last, most[t] / static_cast<double>(t));
      }
      EXPECT_NEAR(last, graph.costliestPower(), graph.costliestPower() * 0.05) << "seed " << seed;
    }
  }
  EXPECT_GT(with_cycle, 100U);
}

TEST(EnergyGraph, TakesTheUseThatIsWorthMost) {
  const EnergyGraph graph(2, {{0, 1, {use(1, 5), use(10, 30)}}, {1, 0, {use(1, 0)}}}, joules);
  EXPECT_DOUBLE_EQ(graph.costliestPower(), 30.0 / 11);
  EXPECT_EQ(graph.verticesOfCycle().size(), 2U);
  EXPECT_EQ(graph.greatestWalk(4).seconds, 1);
  EXPECT_EQ(graph.greatestWalk(2.8).seconds, 1);
}

/// Steeper lines take more in a second; they do not make time pass faster.
TEST(EnergyLines, LastAsLongAsTheyAreFor) {
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  const ir::Mission none;
  const ir::prove::GreatestPower power(none, slocum(), std::nullopt);
  const auto all = [&](const EnergyUse& one) { return power.joules(one); };
  // A costly way into a cheap circle: soon the steep lines are lower.
  const EnergyGraph graph(3, {{0, 1, {use(20, 900)}}, {1, 2, {use(300, 30)}}, {2, 1, {use(4, 1)}}},
                          all);
  const ir::prove::EnergyLines lines = linesOf(graph, power);
  EXPECT_GT(lines.size(), 2U);
  for (const ir::prove::EnergyLine& line : lines) {
    EXPECT_EQ(line.rate.seconds, 1);
    EXPECT_EQ(line.offset.seconds, 0);
  }
  for (const double t : {1.0, 25.0, 400.0, 1e6}) {
    EXPECT_NEAR(usesWithin(lines, power, t, t).front().seconds, t, 1e-9 * t);
  }
}

TEST(EnergyGraph, HasNoCycleWhereNothingComesBack) {
  const EnergyGraph graph(3, {{0, 1, {use(5, 10)}}, {1, 2, {use(5, 20)}}}, joules);
  EXPECT_EQ(graph.costliestCycle().seconds, 0);
  EXPECT_EQ(graph.costliestPower(), 0);
  EXPECT_EQ(joules(graph.greatestWalk(0)), 30);
  EXPECT_EQ(graph.greatestWalk(2.5).seconds, 10);
  EXPECT_EQ(graph.greatestWalk(5).seconds, 0);
}

}  // namespace
}  // namespace glider::tests
