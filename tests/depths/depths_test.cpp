// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How deep a vehicle goes whose sensors are wrong, by its true depth, and how deep the layered
// control's own yo goes with the same fault. scripts/soak/depths flies all and prints the table.

#include "tests/depths/depth_faults.h"
#include "tests/depths/depth_flight.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

namespace glider::tests {
namespace {

constexpr double kPast = 10;    // m
constexpr double kTwo = 1.5;    // times max_depth
constexpr double kWorse = 5;    // m, than the layered control
constexpr double kWater = 500;  // m
constexpr double kDepthsHours = 1.2;

/// A plan under this max_depth, m, and whether a yo of the layered control does the same.
struct Profile {
  const char* name;
  double greatest_m;
  Plan plan;
  bool is_layered;
};
constexpr Profile kProfiles[] = {
    {"yo to 55 m", 60, {.top_m = 4, .bottom_m = 55}, true},
    {"yo to 30 m", 60, {.top_m = 4, .bottom_m = 30}, true},
    {"steep yo to 58 m", 60, {.top_m = 4, .bottom_m = 58, .pitch_rad = 0.6}, false},
    {"hover at 50 m", 60, {.bottom_m = 50, .hovers = true}, false},
    {"yo at 45 degrees to 28 m", 30, {.top_m = 4, .bottom_m = 28, .pitch_rad = 0.785}, false},
    {"hover at 20 m", 30, {.bottom_m = 20, .hovers = true}, false}};

/// One fault in all of its flights.
struct Row {
  double ctd_m = -1e9, alone_m = -1e9;  ///< past max_depth at most, with and without a CTD
  double worse_m = -1e9;    ///< deeper than the layered control and a whole vehicle, at most
  double layered_m = -1e9;  ///< the layered control, of the yos
  bool failed = false;
  bool differs = true;  ///< from the flights without what is wrong with any one of its sensors
};

class Judge {
 public:
  explicit Judge(uint64_t times) : times_(times) {
    for (size_t i = 0; i < std::size(kProfiles); ++i) {
      whole_m_.at(i) = fly(i, {}).deepest_m;
    }
  }

  /// Flies `fault` in each profile from each of the times on.
  Row row(const DepthFault& fault, size_t profiles) {
    Row row;
    std::vector<DepthFault> parts = fault.parts();
    for (size_t i = 0; i < profiles; ++i) {
      for (uint64_t k = 0; k < times_; ++k) {
        // Over a yo to 55 m, which takes some 500 s; the first at the start.
        flights(fault, i,
                k == 0 ? 0 : 900 + 500.0 / static_cast<double>(times_) * static_cast<double>(k),
                parts, row);
      }
    }
    row.differs = parts.empty();
    return row;
  }

 private:
  /// Removes from `parts` those whose flights differ from those of the whole fault.
  void compare(size_t profile, double from_s, uint64_t with_ctd, uint64_t without,
               std::vector<DepthFault>& parts) {
    std::erase_if(parts, [&](const DepthFault& part) {
      return fly(profile, part.from(from_s)).fingerprint != with_ctd ||
             fly(profile, withoutCtd(part.from(from_s))).fingerprint != without;
    });
  }

  void flights(const DepthFault& fault, size_t profile, double from_s,
               std::vector<DepthFault>& parts, Row& row) {
    const Dived ctd = fly(profile, fault.from(from_s));
    const Dived alone = fly(profile, withoutCtd(fault.from(from_s)));
    compare(profile, from_s, ctd.fingerprint, alone.fingerprint, parts);
    const double with_ctd = ctd.deepest_m;
    const double greatest = kProfiles[profile].greatest_m;
    row.ctd_m = std::max(row.ctd_m, with_ctd - greatest);
    const double without = alone.deepest_m;
    row.alone_m = std::max(row.alone_m, without - greatest);
    judge(fault, profile, from_s, with_ctd, without, row);
    if (kProfiles[profile].is_layered) {
      simulator::Scenario scenario =
          diveScenario(layeredSkeleton(greatest, kProfiles[profile].plan.bottom_m), kWater);
      scenario.duration_s = kDepthsHours * 3600;
      scenario.faults = fault.from(from_s);
      const double layered = flyDive(nullptr, scenario, 1).deepest_m;
      row.layered_m = std::max(row.layered_m, layered - greatest);
      // A layered yo that turns early is not better than one that goes to its commanded depth.
      const double without_ctd = fault.rule == DepthRule::Wrong ? without : 0;
      const double worse =
          std::max(with_ctd, without_ctd) - std::max(layered, whole_m_.at(profile));
      row.worse_m = std::max(row.worse_m, worse);
      EXPECT_LE(worse, kWorse) << fault.name << " from " << from_s << " s, "
                               << kProfiles[profile].name << ": the layered control " << layered;
    }
  }

  void judge(const DepthFault& fault, size_t profile, double from_s, double with_ctd,
             double without, Row& row) {
    const double greatest = kProfiles[profile].greatest_m;
    const double bound = fault.rule == DepthRule::Two ? kTwo * greatest : greatest + kPast;
    const bool counts = fault.rule == DepthRule::Wrong;  // also without a CTD
    const double worst = counts ? std::max(with_ctd, without) : with_ctd;
    row.failed = row.failed || worst > bound;
    EXPECT_LE(worst, bound) << fault.name << " from " << from_s << " s, " << kProfiles[profile].name
                            << ": " << with_ctd << " m, without a CTD " << without << " m";
  }

  static simulator::Faults withoutCtd(simulator::Faults faults) {
    faults.sensors.push_back(noCtd());
    return faults;
  }

  Dived fly(size_t profile, simulator::Faults faults) {
    simulator::Scenario scenario =
        diveScenario(hookbehSkeleton(kProfiles[profile].greatest_m), kWater);
    scenario.duration_s = kDepthsHours * 3600;
    scenario.faults = std::move(faults);
    return flyDive(&kProfiles[profile].plan, scenario, 1);
  }

  uint64_t times_;
  std::array<double, std::size(kProfiles)> whole_m_ = {};  ///< where nothing is wrong
};

void print(const DepthFault& fault, const Row& row) {
  fmt::print("| {} | {:+.1f} | {:+.1f} | {:+.1f} | {:+.1f} |{}\n", fault.name, row.ctd_m,
             row.alone_m, row.layered_m, row.worse_m, row.failed ? " **too deep**" : "");
  std::fflush(stdout);
}

/// The faults that change no flight, or beside another fault none: their rows would say nothing.
std::set<std::string> withoutEffect() {
  std::ifstream in(GLIDER_SOURCE_DIR "/tests/depths/without_effect.txt");
  std::set<std::string> names;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("#")) {
      names.insert(line);
    }
  }
  return names;
}

TEST(Depths, StayNearTheGreatestWhicheverSensorIsWrong) {
  const uint64_t times = wantedNumber("GLIDER_DEPTHS_ALL", 0);
  const bool all = times != 0;
  Judge judge(all ? times : 2);
  std::vector<DepthFault> faults = singleDepthFaults();
  const std::set<std::string> without_effect = withoutEffect();
  EXPECT_FALSE(without_effect.empty());
  if (all) {
    const auto two = doubleDepthFaults();
    faults.insert(faults.end(), two.begin(), two.end());
    fmt::print(
        "| fault | with a CTD, m | without, m | layered control, m | deeper than it, m "
        "|\n|---|---|---|---|---|\n");
  }
  const char* only = std::getenv("GLIDER_DEPTHS_ONLY");
  for (const DepthFault& fault : faults) {
    if (only != nullptr && fault.name.find(only) == std::string::npos) {
      continue;
    }
    // The suite's share: what touches the depth, in the deep yo.
    const bool few =
        fault.name.starts_with("m_depth ") || fault.name.starts_with("sci_water_pressure ");
    if (!all && (!few || fault.name.find("jumps") != std::string::npos)) {
      continue;
    }
    const Row row = judge.row(fault, all ? std::size(kProfiles) : 1);
    const bool listed = without_effect.contains(fault.name);
    EXPECT_TRUE(!all || row.differs || listed)
        << fault.name << ": a flight without one of its faults is the same";
    EXPECT_FALSE(row.differs && listed) << fault.name << ": it has an effect, and is listed";
    if (all && row.differs) {
      print(fault, row);
    }
  }
}

TEST(Depths, AStuckDepthThatFlickersIsSeenInEachProfile) {
  Judge judge(2);
  for (const DepthFault& fault : singleDepthFaults()) {
    if (fault.name == "m_depth flickers" || fault.name == "m_depth wavers" ||
        fault.name == "m_pressure flickers, 0.25 missing") {
      judge.row(fault, std::size(kProfiles));
    }
  }
}

TEST(Depths, TwoWrongAtOnceStayWithinHalfAsMuchAgain) {
  if (wantedNumber("GLIDER_DEPTHS_ALL", 0) != 0) {
    GTEST_SKIP() << "flown by the other test";
  }
  Judge judge(2);
  size_t number = 0;
  for (const DepthFault& fault : doubleDepthFaults()) {
    if (number++ % 8 == 0) {
      judge.row(fault, 1);
    }
  }
}

TEST(Depths, AVehicleWithoutFaultsGoesAsDeepAsCommanded) {
  Judge judge(1);
  const Row row = judge.row({"none", DepthRule::Wrong, {}}, std::size(kProfiles));
  EXPECT_GT(row.ctd_m, 1) << "the steep ones, before they turn";
  EXPECT_LT(row.ctd_m, 6);
  EXPECT_GT(row.layered_m, -5) << "the layered control too";
}

}  // namespace
}  // namespace glider::tests
