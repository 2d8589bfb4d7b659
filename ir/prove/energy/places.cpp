// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/places.h"

#include "ir/prove/abstract/bounds_by_state.h"

#include <algorithm>
#include <utility>

namespace glider::ir::prove {
namespace {

const Case& caseOf(const Mission& mission, uint32_t state, ListKind list, size_t number) {
  return list == ListKind::Always ? mission.always[number] : mission.states[state].cases[number];
}

StayPlaces byStays(const Mission& mission, std::vector<Stay> stays) {
  StayPlaces places;
  for (size_t i = 0; i < stays.size(); ++i) {
    Stay& stay = stays[i];
    places.first = stay.first ? i : places.first;
    places.values.push_back(std::move(stay.values));
    StayPlace place{
        stay.control.state.index, stay.control.just_returned, &places.values.back(), {}, {}};
    for (uint32_t k = 0; k < mission.always.size(); ++k) {
      if (stay.control.mayInterrupt(mission, k)) {
        place.always.push_back(&mission.always[k]);
      }
    }
    for (const StayWay& way : stay.ways) {
      if (place.steps.empty() || place.steps.back().list != way.list ||
          place.steps.back().number != way.number) {
        place.steps.push_back(
            {&caseOf(mission, place.state, way.list, way.number), way.list, way.number, {}});
      }
      if (way.to) {
        place.steps.back().to.push_back(*way.to);
      }
    }
    places.all.push_back(std::move(place));
  }
  return places;
}

/// Two places for each state: as it is entered, and as it is resumed.
class ByStates {
 public:
  explicit ByStates(const Mission& mission) : m_(mission), limits_(greatestLimits(mission)) {
    places_.values.push_back(anyValues(m_));
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      if (mayWait(m_, {i})) {
        resumed_.push_back(2 * size_t{i} + 1);
      }
    }
  }

  StayPlaces run() {
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      for (const bool again : {false, true}) {
        StayPlace place{i, again, &places_.values.front(), neverPrevented(m_), {}};
        addSteps(place, ListKind::State, m_.states[i].cases.size());
        addSteps(place, ListKind::Always, std::min(limits_[i], m_.always.size()));
        places_.all.push_back(std::move(place));
      }
    }
    return std::move(places_);
  }

 private:
  void addSteps(StayPlace& place, ListKind list, size_t count) const {
    for (size_t k = 0; k < count; ++k) {
      const Case& c = caseOf(m_, place.state, list, k);
      const bool itself =
          list == ListKind::Always && c.target.valid() && c.target.index == place.state;
      if (!staysIn(c.transition) && !itself) {
        StayStep step{&c, list, k, {}};
        if (c.transition == Transition::Return) {
          step.to = resumed_;
        } else if (c.target.valid()) {
          step.to = {2 * size_t{c.target.index}};
        }
        place.steps.push_back(std::move(step));
      }
    }
  }

  const Mission& m_;
  std::vector<size_t> limits_;
  std::vector<size_t> resumed_;  ///< places to which a `return` may lead
  StayPlaces places_;
};

}  // namespace

StayPlaces placesOf(const ProofContext& proof_context) {
  std::vector<Stay> stays = staysOf(proof_context);
  return stays.empty() ? ByStates(proof_context.mission).run()
                       : byStays(proof_context.mission, std::move(stays));
}

}  // namespace glider::ir::prove
