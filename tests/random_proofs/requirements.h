// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"
#include "tests/random_missions/random.h"

#include <string>
#include <vector>

namespace glider::random_proofs {

/// A mission with requirements, and the kind of each: "exit within", "patrol".
struct Required {
  ir::Mission mission;
  std::vector<std::string> kinds;
};

/// Adds requirements of every kind to a mission that has none: near to what a few flights did, so
/// that a good share is proved and a good share is not. Sometimes also assumptions, and cases that
/// are due about where the vehicle can just get.
Required withRequirements(const ir::Mission& without, const platforms::Platform& platform,
                          uint64_t seed);

}  // namespace glider::random_proofs
