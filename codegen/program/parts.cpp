// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/program/parts.h"

#include <algorithm>
#include <numeric>

namespace glider::codegen {
namespace {

// A part costs about as much as a small state, whatever is in it.
constexpr size_t kFewestStates = 2;  ///< of a mission in parts
constexpr size_t kManyStates = 64;

size_t countOf(size_t states) {
  if (states < kFewestStates) {
    return 1;
  }
  return states < kManyStates ? 2 : 8;
}

size_t workOf(const ir::Activity& activity) {
  return activity.cases.size() + (activity.entry.valid() ? 1 : 0);
}

size_t workOf(const ir::State& state) {
  // A profile's cases do more than a state's: they command.
  return 1 + state.cases.size() + 3 * (workOf(state.profile) + workOf(state.route));
}

}  // namespace

std::vector<MissionPart> partsOf(const ir::Mission& mission) {
  std::vector<MissionPart> parts(countOf(mission.states.size()), {false, {}});
  parts.front().head = true;
  std::vector<size_t> work(parts.size());
  std::vector<uint32_t> largest_first(mission.states.size());
  std::iota(largest_first.begin(), largest_first.end(), 0U);
  std::ranges::stable_sort(largest_first, std::greater{},
                           [&](uint32_t i) { return workOf(mission.states[i]); });
  for (const uint32_t state : largest_first) {
    const auto least = static_cast<size_t>(std::ranges::min_element(work) - work.begin());
    parts[least].states.push_back(state);
    work[least] += workOf(mission.states[state]);
  }
  for (MissionPart& part : parts) {
    std::ranges::sort(part.states);
  }
  return parts;
}

}  // namespace glider::codegen
