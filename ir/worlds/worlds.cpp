// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/worlds/worlds.h"

#include "ir/worlds/under_assumptions.h"

#include <utility>
#include <vector>

namespace glider::ir {

Worlds::Worlds(const Mission& mission, const platforms::Platform& platform)
    : written{mission, platform},
      widest{mission, notNarrowed(platform, mission)},
      assumed{underAssumptions(mission), underAssumptions(widest.platform, mission)} {}

AssumedWorld assuming(const WidestWorld& widest, std::span<const uint32_t> assumptions) {
  Mission mission = widest.mission;
  std::vector<Assumption> some;
  for (const uint32_t number : assumptions) {
    some.push_back(mission.assumptions.at(number));
  }
  mission.assumptions = std::move(some);
  platforms::Platform platform = underAssumptions(widest.platform, mission);
  return {underAssumptions(std::move(mission)), std::move(platform)};
}

}  // namespace glider::ir
