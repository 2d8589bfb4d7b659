// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/bounds_by_state.h"

#include "ir/prove/abstract/earliest_entry.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/verify/intervals.h"

#include <algorithm>
#include <limits>

namespace glider::ir::prove {
namespace {

bool calls(const std::vector<Case>& cases) {
  return std::ranges::find(cases, Transition::Call, &Case::transition) != cases.end();
}

}  // namespace

bool mayWait(const Mission& mission, StateId state) {
  return calls(mission.always) || calls(mission[state].cases);
}

Cases neverPrevented(const Mission& mission) {
  Cases found;
  for (const Case& c : mission.always) {
    if (c.target.valid()) {
      break;
    }
    found.push_back(&c);
  }
  return found;
}

std::vector<size_t> greatestLimits(const Mission& mission) {
  constexpr size_t kNone = std::numeric_limits<size_t>::max();
  std::vector<size_t> limits(mission.states.size());
  std::vector<bool> entered(mission.states.size());
  std::vector<uint32_t> open;
  const auto raise = [&](StateId state, size_t limit) {
    if (!entered[state.index] || limit > limits[state.index]) {
      entered[state.index] = true;
      limits[state.index] = limit;
      open.push_back(state.index);
    }
  };
  raise({0}, kNone);
  for (size_t i = 0; i < mission.always.size(); ++i) {
    if (mission.always[i].target.valid()) {
      raise(mission.always[i].target, i);
    }
  }
  // What is added to `open` meanwhile is followed too.
  for (size_t next = 0; next < open.size(); ++next) {
    const uint32_t at = open[next];
    for (const Case& c : mission.states[at].cases) {
      if (c.target.valid()) {
        raise(c.target, c.transition == Transition::Call ? limits[at] : kNone);
      }
    }
  }
  return limits;
}

Valuation anyValues(const Mission& mission) {
  Valuation values;
  for (const Variable& variable : mission.variables) {
    values.push_back(anything(variable));
  }
  return values;
}

std::vector<StateBounds> boundsOfStates(const ProofContext& proof_context, const EndBound& end) {
  const Mission& m = proof_context.mission;
  const std::vector<double> depths = deepestByState(proof_context);
  const std::vector<double> entries = earliestEntries(proof_context);
  const Valuation values = anyValues(m);
  const Interruptions always{neverPrevented(m), false};
  std::vector<StateBounds> all;
  for (uint32_t i = 0; i < m.states.size(); ++i) {
    const double latest = end.by ? end.left_by[i] : kGreatestNumber;
    StateBounds bounds{entries[i], latest, latest, latest, depths[i]};
    bounds.resume_time = std::min(latest, stayOf(proof_context, m.states[i], always, values).by);
    if (!mayWait(m, {i})) {
      bounds.state_time = bounds.resume_time;
    }
    all.push_back(bounds);
  }
  return all;
}

std::vector<StateBounds> stateBounds(const ProofContext& proof_context, const EndBound& end) {
  return ofPossibleStates(boundsOfStates(proof_context, end), end);
}

std::vector<StateBounds> ofPossibleStates(std::vector<StateBounds> all, const EndBound& end) {
  std::erase_if(all, [&](const StateBounds& one) {
    return (end.by && one.latest == 0) || one.earliest > one.latest;
  });
  return all;
}

}  // namespace glider::ir::prove
