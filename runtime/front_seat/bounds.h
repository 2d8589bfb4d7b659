// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "hooks/protocol/values.h"

namespace glider::runtime {

/// What may be commanded of a vehicle that goes to a depth at a speed.
struct CommandLimits {
  double greatest_depth_m = 0;
  double slowest_m_s = 0;  ///< through the water
  double fastest_m_s = 0;
};

/// Whether the vehicle may be given that. It does not refuse what is beyond its limits but flies
/// something else, so they are kept here.
hooks::HookAnswer checkBounds(const hooks::Instruction& instruction, const CommandLimits& limits);

}  // namespace glider::runtime
