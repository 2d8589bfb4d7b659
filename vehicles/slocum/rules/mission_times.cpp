// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/context/proof_context.h"
#include "vehicles/slocum/rules/control.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace glider::slocum::rules {

MissionTimes::MissionTimes(const ir::WidestWorld& world, double starts_s) : starts_s_(starts_s) {
  const ir::Mission& mission = world.mission;
  const ir::prove::ProofContext proof_context(world);
  const ir::prove::ProofContext powered = proof_context.withoutPowerCuts();
  const auto end = ir::prove::boundOf(powered, ir::prove::kLongestMission, ir::prove::Goal::Exit);
  ends_s_ = end.by;
  const auto bounds = ir::prove::boundsOfStates(powered, end);
  for (size_t i = 0; i < mission.states.size(); ++i) {
    states_.push_back({mission.states[i].name, bounds[i].earliest, bounds[i].latest});
  }
}

bool MissionTimes::fliesAt(double vehicle_s) const {
  return !ends_s_ || vehicle_s < starts_s_ + *ends_s_;
}

std::string MissionTimes::stateAt(double vehicle_s) const {
  constexpr size_t kMostNames = 3;
  const double mission_s = std::max(0.0, vehicle_s - starts_s_);
  std::vector<std::string> names;
  for (const Current& state : states_) {
    if (state.earliest_s <= mission_s && mission_s <= state.latest_s) {
      names.push_back("`" + state.name + "`");
    }
  }
  if (names.empty() || names.size() > kMostNames) {
    return "";
  }
  return names.size() == 1 ? "in state " + names.front()
                           : fmt::format("in one of the states {}", fmt::join(names, ", "));
}

std::string MissionTimes::endText() const {
  return ends_s_ ? fmt::format("the mission may fly for {}", ir::prove::durationOf(*ends_s_))
                 : "the mission has no proved end";
}

}  // namespace glider::slocum::rules
