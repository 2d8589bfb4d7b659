// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>
#include <set>
#include <vector>

namespace glider::tests {

/// What SPIN finds in one mission.
struct SpinFindings {
  std::set<uint32_t> reached;        ///< states
  std::set<uint32_t> empty_returns;  ///< states that return with an empty call stack
  bool recursive = false;            ///< a state calls one that is on the stack, or itself
  uint32_t depth = 0;  ///< the greatest number of states on the stack; not if recursive
};

/// Lets SPIN search the models of all missions (at most 200) in one program. Fails the test if SPIN
/// or the compiler of its program do.
std::vector<SpinFindings> searchWithSpin(const std::vector<ir::Mission>& missions);

}  // namespace glider::tests
