// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/surfacing_places.h"

#include "ir/prove/abstract/bounds_by_state.h"

namespace glider::ir::prove {

SurfacingPlaces SurfacingPlaces::ofStates(const Mission& mission) {
  return {mission, false};
}
SurfacingPlaces SurfacingPlaces::ofConfigurations(const Mission& mission) {
  return {mission, true};
}

SurfacingPlaces::SurfacingPlaces(const Mission& mission, bool exact)
    : mission_(&mission),
      count_(mission.states.size()),
      exact_(exact),
      limits_(greatestLimits(mission)),
      callers_(count_) {
  if (exact) {
    Control control;
    control.state = {0};
    idOf(std::move(control));
    return;
  }
  for (uint32_t i = 0; i < count_; ++i) {
    for (const Case& c : mission.states[i].cases) {
      addCaller(c, i);
    }
    for (size_t k = 0; k < mission.always.size(); ++k) {
      if (mayInterruptState(i, k)) {
        addCaller(mission.always[k], i);
      }
    }
  }
}

size_t SurfacingPlaces::size() const {
  return exact_ ? exact_places_.size() : 3 * count_;
}

uint32_t SurfacingPlaces::stateOf(size_t at) const {
  return exact_ ? controlAt(at).state.index : static_cast<uint32_t>(at % count_);
}

bool SurfacingPlaces::isAgain(size_t at) const {
  return exact_ ? exact_places_[at].second : at >= count_;
}

bool SurfacingPlaces::mayInterrupt(size_t at, size_t always_case) const {
  return exact_ ? controlAt(at).mayInterrupt(*mission_, static_cast<uint32_t>(always_case))
                : mayInterruptState(stateOf(at), always_case);
}

bool SurfacingPlaces::mayInterruptState(uint32_t state, size_t always_case) const {
  const StateId target = mission_->always[always_case].target;
  return always_case < limits_[state] && !(target.valid() && target.index == state);
}

std::optional<size_t> SurfacingPlaces::ledTo(size_t at, ListKind list, size_t number) {
  const uint32_t state = stateOf(at);
  const Case& c =
      list == ListKind::Always ? mission_->always[number] : mission_->states[state].cases[number];
  const bool returns = c.transition == Transition::Return;
  if (!exact_) {
    return returns ? 2 * count_ + state : c.target.index;
  }
  if (returns && controlAt(at).stack.empty()) {
    return std::nullopt;  // GL3005
  }
  return idOf(controlAt(at).moved(list, static_cast<uint32_t>(number), c));
}

std::vector<size_t> SurfacingPlaces::goingOn(size_t at) const {
  std::vector<size_t> places;
  for (const uint32_t caller : callers_[at % count_]) {
    places.push_back(ofState(caller, true));
  }
  return places;
}

size_t SurfacingPlaces::idOf(Control control) {
  const bool again = control.just_returned;
  control.just_returned = false;
  const auto [found, is_new] =
      ids_.emplace(std::pair{std::move(control), again}, exact_places_.size());
  if (is_new) {
    exact_places_.push_back(found->first);
  }
  return found->second;
}

void SurfacingPlaces::addCaller(const Case& c, uint32_t state) {
  if (c.transition == Transition::Call) {
    callers_[c.target.index].push_back(state);
  }
}

}  // namespace glider::ir::prove
