// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// No mission that is bred to take much takes more than energyBoundOf says. Those of random missions
// that come near their bounds are changed and flown again: so it finds what thousands of random
// missions do not. Most of them fly on a vehicle that uses its energy for the pump alone: there no
// slack of what other devices take hides a rule that counts too few strokes.
// scripts/soak/energy_search breeds for hours.

#include "simulator/scenario/scenario.h"
#include "support/diagnostics/engine.h"
#include "tests/energy/hungry_mission.h"
#include "tests/energy/watched_energy.h"
#include "tests/world/fleet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace glider::tests {
namespace {

using ir::prove::Rng;

struct Bred {
  HungryMission mission;
  FlownEnergy flown;
  std::string eater;
};

/// What draws power on a vehicle, and water in which it takes all that it may.
struct Eater {
  std::string name;
  platforms::Platform platform;
  platforms::BoardPower board;
  simulator::Scenario sea;
  bool naps = false;  ///< its SBC sleeps where it may
};

/// The best of each eater and power, by whole W.
using Best = std::map<std::pair<std::string, int>, Bred>;

void keepBetter(Best& best, const Best::key_type& key, const Bred& one) {
  const auto [place, first] = best.try_emplace(key, one);
  if (!first && one.flown.nearest > place->second.flown.nearest) {
    place->second = one;
  }
}

/// No water helps or hinders it.
simulator::Scenario stillWater(const platforms::Platform& platform,
                               const platforms::BoardPower& board) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto path = std::filesystem::path(GLIDER_SOURCE_DIR) / "tests/energy/still.toml";
  simulator::Scenario still = *simulator::loadScenario(path, platform, sources, diagnostics);
  setHunger(still.vehicle, board, [] { return 1; });
  return still;
}

Eater usualEater() {
  return {"usual", slocum(), usualBoardPower(), stillWater(slocum(), usualBoardPower())};
}

/// Its other devices take next to nothing.
Eater pumpEater() {
  constexpr double kNext = 0.01;
  platforms::Platform platform = slocum();
  for (platforms::Draw& draw : platform.power.draws) {
    const bool pump =
        draw.when == platforms::DrawWhen::PumpOut || draw.when == platforms::DrawWhen::PumpIn;
    draw.amount *= pump ? 1 : kNext;
  }
  platforms::BoardPower board = usualBoardPower();
  board.running_W *= kNext;
  simulator::Scenario sea = stillWater(platform, board);
  return {"pump", std::move(platform), board, std::move(sea)};
}

/// The same, with an SBC that sleeps: its commands may come later.
Eater nappingEater() {
  Eater eater = pumpEater();
  eater.name = "naps";
  eater.naps = true;
  return eater;
}

/// The mission as it flies with this eater.
std::string textFor(const Eater& eater, const HungryMission& mission) {
  std::string text = textOf(mission);
  if (eater.naps) {
    text.insert(text.find('\n') + 1, "nap at most 4 min\n");
  }
  return text;
}

/// Missions of one seed. The dangerous ones come first.
class Strain {
 public:
  explicit Strain(uint64_t seed) : dice_(seed) {}

  /// What the next one took; it has not been flown before.
  Bred next() {
    Bred one{choose(), {}, {}};
    while (!known_.insert(textOf(one.mission)).second) {
      one.mission = mutated(std::move(one.mission), dice_);
    }
    const std::string name = fmt::format("hungry {}", known_.size());
    const Eater& eater = eaters_.at(known_.size() % eaters_.size());
    const FlyingMission mission = *loadMission(name, textFor(eater, one.mission));
    if (const auto bound = boundOfEnergy(mission, eater.platform, eater.board)) {
      one.eater = eater.name;
      one.flown = flyForEnergy(mission, *bound, eater.sea, known_.size());
      keep(one);
    }
    return one;
  }

  /// Of those that flew for long.
  [[nodiscard]] const Best& best() const { return best_; }

 private:
  static constexpr size_t kDangerous = 30;

  HungryMission choose() {
    if (known_.size() < kDangerous) {
      return dangerousMission(known_.size() / eaters_.size(), dice_);
    }
    if (best_.empty() || dice_.chance(0.15)) {
      return dice_.chance(0.2) ? dangerousMission(dice_.below(kDangerous), dice_)
                               : drawHungryMission(dice_);
    }
    const auto parent = std::next(best_.begin(), dice_.below(best_.size()));
    return mutated(parent->second.mission, dice_);
  }

  /// The best of each power: one that stays at the surface comes near its bound and leads nowhere.
  void keep(const Bred& one) {
    constexpr double kLong_s = 3600;
    if (one.flown.seconds >= kLong_s) {
      const int watts = static_cast<int>(one.flown.used_j / one.flown.seconds);
      keepBetter(best_, {one.eater, watts}, one);
    }
  }

  Rng dice_;
  std::array<Eater, 3> eaters_ = {pumpEater(), usualEater(), nappingEater()};
  std::set<std::string> known_;
  Best best_;
};

/// "usual: 0.873 of the bound: 13.10 Wh in 1.50 h".
std::string found(const Bred& one) {
  return fmt::format("{:5}: {:.3f} of the bound: {:.2f} Wh in {:.2f} h", one.eater,
                     one.flown.nearest, one.flown.used_j / 3600, one.flown.seconds / 3600);
}

/// Those that came nearest to their bounds, and how near each power did.
void print(const Best& best) {
  std::vector<const Bred*> order;
  for (const auto& [key, one] : best) {
    fmt::print("{:2} W, {}\n", key.second, found(one));
    order.push_back(&one);
  }
  std::ranges::sort(order, std::ranges::greater{},
                    [](const Bred* one) { return one->flown.nearest; });
  for (size_t i = 0; i < std::min<size_t>(5, order.size()); ++i) {
    fmt::print("\n{}\n{}", found(*order[i]), textOf(order[i]->mission));
  }
}

TEST(EnergySearch, NoMissionThatIsBredTakesMore) {
  constexpr uint64_t kFew = 60, kStrain = 500;
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  const uint64_t count = wanted("GLIDER_ENERGY_SEARCH", kFew);
  const uint64_t seed = wanted("GLIDER_ENERGY_SEARCH_SEED", 1);
  Best best;
  // A strain that no longer gets better is left for the next seed's.
  for (uint64_t i = 0; i < count; i += kStrain) {
    Strain strain(seed + i / kStrain);
    for (uint64_t k = 0; k < std::min(kStrain, count - i); ++k) {
      const Bred one = strain.next();
      ASSERT_LE(one.flown.nearest, 1)
          << "mission " << k + 1 << " of seed " << seed + i / kStrain << ", " << found(one) << ":\n"
          << textOf(one.mission);
    }
    for (const auto& [key, one] : strain.best()) {
      keepBetter(best, key, one);
    }
    if (count > kFew) {
      fmt::print("{} of {}\n", std::min(i + kStrain, count), count);
      std::fflush(stdout);  // who waits for hours sees it
    }
  }
  EXPECT_GT(best.size(), 8U) << "the missions are all alike";
  if (count > kFew) {
    print(best);
  }
}

}  // namespace
}  // namespace glider::tests
