// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Thermocline tracking in the language, as the library's profile and as a mission of states and
// variables, in the waters of the paper: its Figure 5, the readings on which its first deployment
// failed, the lost climb of its Figure 6.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace glider::tests {
namespace {

constexpr double kNarrow = 12;  ///< m, more than the range that tracking commands

/// Where the glider turns from a climb into a dive: the least depths, each 2 m below what follows.
std::vector<size_t> shallowTurns(const std::vector<double>& depth) {
  std::vector<size_t> turns;
  bool diving = true;
  size_t extreme = 0;
  for (size_t i = 0; i < depth.size(); ++i) {
    const bool further = diving ? depth[i] >= depth[extreme] : depth[i] <= depth[extreme];
    if (further) {
      extreme = i;
    } else if (std::abs(depth[i] - depth[extreme]) > 2) {
      if (!diving) {
        turns.push_back(extreme);
      }
      diving = !diving;
      extreme = i;
    }
  }
  return turns;
}

/// How a flight's commanded range changed, tick by tick.
class Tracked {
 public:
  explicit Tracked(const Flight& flight)
      : time(flight.column("time")),
        depth(flight.column("true_depth")),
        active_(flight.column("hook_active")),
        top_(flight.column("commanded_top")),
        bottom_(flight.column("commanded_bottom")),
        isotherm_(flight.column("isotherm_depth")) {
    first = static_cast<size_t>(std::ranges::find(active_, 1.0) - active_.begin());
    last = first;
    for (size_t i = 0; i < active_.size(); ++i) {
      last = active_[i] == 1 ? i : last;
    }
    detected = first;
    while (detected < last && width(detected) > kNarrow) {
      ++detected;
    }
    for (const size_t turn : shallowTurns(depth)) {
      if (turn > detected && second_yo == 0) {
        second_yo = turn;
      }
    }
  }

  [[nodiscard]] double width(size_t i) const {
    const double wide = bottom_[i] - top_[i];
    return wide == wide ? wide : 1000;
  }
  [[nodiscard]] bool holdsIsotherm(size_t i) const {
    return top_[i] <= isotherm_[i] && isotherm_[i] <= bottom_[i];
  }
  /// Of the ticks from `begin` on, the share for which `holds` does.
  template <typename Holds>
  [[nodiscard]] double share(size_t begin, Holds holds) const {
    size_t good = 0;
    for (size_t i = begin; i <= last; ++i) {
      good += holds(i) ? 1U : 0U;
    }
    return static_cast<double>(good) / static_cast<double>(last + 1 - begin);
  }

  std::vector<double> time;
  std::vector<double> depth;
  size_t first = 0;      ///< row at which the SBC flies
  size_t last = 0;       ///< and last does
  size_t detected = 0;   ///< where the commanded range is first narrow
  size_t second_yo = 0;  ///< where the yo after that of the detection begins

 private:
  std::vector<double> active_, top_, bottom_, isotherm_;
};

void expectControlThroughout(const Flight& flight, const Tracked& tracked) {
  const auto active = flight.column("hook_active");
  for (size_t i = tracked.first; i <= tracked.last; ++i) {
    ASSERT_EQ(active[i], 1) << "control is lost at " << tracked.time[i] << " s";
  }
  EXPECT_GE(tracked.time[tracked.last] - tracked.time[tracked.first], 1190);
  for (const Event& event : flight.events) {
    EXPECT_NE(event.kind, "abort") << event.what;
    EXPECT_EQ(event.what.find("refused"), std::string::npos) << event.what;
  }
}

/// From the second yo after detection on the commanded range contains the isotherm, and is narrow
/// on `narrow` of the ticks.
void expectTracked(const Tracked& tracked, double narrow) {
  ASSERT_GT(tracked.second_yo, tracked.detected);
  EXPECT_GE(tracked.last - tracked.second_yo, 150U) << "found late";
  EXPECT_GE(tracked.share(tracked.second_yo, [&](size_t i) { return tracked.holdsIsotherm(i); }),
            0.88);
  EXPECT_GE(tracked.share(tracked.second_yo, [&](size_t i) { return tracked.width(i) <= kNarrow; }),
            narrow);
}

class Thermocline : public testing::TestWithParam<const char*> {
 protected:
  /// Flies the mission of this case; each property holds of every seed.
  static Flight flown(const std::string& scenario, int seed) {
    const Flight flight =
        fly(project("missions/") + GetParam() + ".mission --scenario " +
            project("scenarios/" + scenario + ".toml") + " --seed " + std::to_string(seed));
    // A tracker that overshoots the scenario's max_depth makes hookbeh climb, which is a warning.
    EXPECT_TRUE(flight.outcome.status == 0 ||
                flight.outcome.err.find("climb: too deep") != std::string::npos)
        << flight.outcome.err;
    return flight;
  }
};

constexpr int kSeeds[] = {1, 2, 3, 5, 61, 62};

TEST_P(Thermocline, DoesFigure5) {
  for (const int seed : kSeeds) {
    SCOPED_TRACE(seed);
    const Flight flight = flown("figure5", seed);
    const Tracked tracked(flight);
    expectControlThroughout(flight, tracked);
    expectTracked(tracked, 0.99);
    // It flies what it commands: it overshoots by what the vehicle needs for an inflection.
    for (size_t i = tracked.second_yo; i <= tracked.last; ++i) {
      EXPECT_LT(tracked.depth[i], 28) << tracked.time[i];
    }
  }
}

TEST_P(Thermocline, SurvivesTheReadingsOfTheFirstDeployment) {
  for (const int seed : kSeeds) {
    SCOPED_TRACE(seed);
    const Flight flight = flown("first_deployment", seed);
    const Tracked tracked(flight);
    expectControlThroughout(flight, tracked);
    expectTracked(tracked, 0.9);
  }
}

TEST_P(Thermocline, FindsItAgainOnTheDiveAfterTheLostClimbOfFigure6) {
  for (const int seed : kSeeds) {
    SCOPED_TRACE(seed);
    const Flight flight = flown("figure6", seed);
    const Tracked tracked(flight);
    expectControlThroughout(flight, tracked);
    // The climb is lost: the CTD goes on reading the deep water above the thermocline.
    const auto read = flight.column("sci_water_temp");
    size_t lost = 0;
    for (size_t i = tracked.first; i <= tracked.last; ++i) {
      lost = tracked.depth[i] < 11 && read[i] < 14 ? i : lost;
    }
    ASSERT_GT(lost, 0U) << "the climb was not lost";
    EXPECT_NEAR(tracked.time[lost], 740, 120);
    // Whichever range was commanded then, from the end of the next dive on it is around the
    // thermocline.
    const auto deepest = std::ranges::max_element(
        tracked.depth.begin() + static_cast<ptrdiff_t>(lost),
        tracked.depth.begin() + static_cast<ptrdiff_t>(std::min(lost + 45, tracked.last)));
    const auto again = static_cast<size_t>(deepest - tracked.depth.begin());
    EXPECT_LT(tracked.time[again] - tracked.time[lost], 200);
    // Except for the ticks on which a command crosses the vehicle's line.
    EXPECT_GE(tracked.share(again,
                            [&](size_t i) {
                              return tracked.holdsIsotherm(i) && tracked.width(i) <= kNarrow;
                            }),
              0.98);
    EXPECT_GE(tracked.share(tracked.second_yo, [&](size_t i) { return tracked.holdsIsotherm(i); }),
              0.9);
  }
}

INSTANTIATE_TEST_SUITE_P(Missions, Thermocline, testing::Values("figure5", "gallery/thermocline"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::ranges::replace(name, '/', '_');
                           return name;
                         });

/// What the paper reports of its first deployment: on the bench the detector finds the layer, at
/// sea a reading against the trend empties its window before the change is large enough.
TEST(FirstDeploymentDetector, FindsTheLayerOnTheBenchButNotAtSea) {
  const auto finds = [](const std::string& scenario, int seed) {
    const auto events = fly(project("missions/first_deployment.mission") + " --scenario " +
                            scenario + " --seed " + std::to_string(seed))
                            .transitions();
    return std::ranges::any_of(
        events, [](const Event& event) { return event.what.find("→ track") != std::string::npos; });
  };
  int at_sea = 0;
  for (const int seed : kSeeds) {
    EXPECT_TRUE(finds("figure5", seed)) << seed;
    at_sea += finds("first_deployment", seed);
  }
  EXPECT_LE(at_sea, 1) << "by chance";
}

/// Without comments, blank lines and what it promises, which the flight does not need.
TEST(ThermoclineExample, IsUnderFortyLinesOfTheLanguage) {
  const std::string text = slurp(project("missions/gallery/thermocline.mission"));
  std::istringstream lines(text);
  size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    const bool counts = !line.empty() && !line.starts_with("#") && !line.starts_with("require ");
    count += counts ? 1 : 0;
  }
  EXPECT_LT(count, 40U);
  EXPECT_GT(count, 20U);
  EXPECT_EQ(text.find("extern"), std::string::npos);
  EXPECT_EQ(text.find("thermotrackyo"), std::string::npos);
}

}  // namespace
}  // namespace glider::tests
