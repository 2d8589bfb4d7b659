// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>

namespace glider::codegen {

/// What code is generated for: a mission without errors, and what its checks found out that the
/// code needs. Refers to both, which must outlive it.
struct Input {
  const ir::Mission& mission;
  const platforms::Platform& platform;  ///< that the mission is for; has all required roles
  uint32_t stack_depth = 0;             ///< greatest number of frames on the call stack
};

}  // namespace glider::codegen
