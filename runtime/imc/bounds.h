// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "hooks/protocol/values.h"
#include "runtime/abi/imc_mission.h"

namespace glider::runtime::imc {

/// Whether the vehicle may be given that. It does not refuse what is beyond its limits but flies
/// something else, so they are kept here.
hooks::HookAnswer checkBounds(const hooks::Instruction& instruction,
                              const GliderImcMission& mission);

}  // namespace glider::runtime::imc
