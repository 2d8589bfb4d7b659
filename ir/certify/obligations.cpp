// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/certify/obligations.h"

#include <algorithm>

namespace glider::ir::certify {

std::vector<Script> obligationsOf(const Mission&, const platforms::Platform&, const Requirement&,
                                  std::span<const Invariant>, double) {
  return {};  // being written
}

double longestGap(const Mission& mission, const platforms::Platform& platform) {
  return std::max(platform.world.tick_gap_s, mission.resume_within_s);
}

}  // namespace glider::ir::certify
