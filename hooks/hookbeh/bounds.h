// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/protocol/values.h"

namespace glider::hooks {

/// Whether the b_args allow what `instruction` (a Take or a Steer) wants: Accepted, or why not.
/// Only the numbers that its vertical and lateral use are looked at. The b_args count as the
/// float32 that the sensor array would make of them, so that an instruction of exactly the greatest
/// depth passes.
HookAnswer checkBounds(const Instruction& instruction, const HookbehArgs& args);

}  // namespace glider::hooks
