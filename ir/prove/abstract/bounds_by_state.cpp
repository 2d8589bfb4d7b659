// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/bounds_by_state.h"

#include "ir/prove/abstract/earliest_entry.h"
#include "ir/prove/abstract/state_depths.h"

#include <algorithm>
#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();

bool calls(const std::vector<Case>& cases) {
  return std::ranges::find(cases, Transition::Call, &Case::transition) != cases.end();
}

}  // namespace

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

Valuation anyValues(const Mission& mission) {
  Valuation values;
  for (const Variable& variable : mission.variables) {
    values.push_back(anything(variable));
  }
  return values;
}

std::vector<StateBounds> stateBounds(const ProofContext& proof_context, const EndBound& end) {
  const Mission& m = proof_context.mission;
  const std::vector<double> depths = deepestByState(proof_context);
  const std::vector<double> entries = earliestEntries(proof_context);
  const Valuation values = anyValues(m);
  const Interruptions always{neverPrevented(m), false};
  std::vector<StateBounds> all;
  for (uint32_t i = 0; i < m.states.size(); ++i) {
    const double latest = end.by ? end.left_by[i] : kMost;
    if ((end.by && latest == 0) || entries[i] > latest) {
      continue;
    }
    StateBounds bounds{entries[i], latest, latest, latest, depths[i]};
    bounds.resume_time = std::min(latest, stayOf(proof_context, m.states[i], always, values).by);
    if (!calls(m.always) && !calls(m.states[i].cases)) {
      bounds.state_time = bounds.resume_time;
    }
    all.push_back(bounds);
  }
  return all;
}

}  // namespace glider::ir::prove
