// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_BOUNDS_H
#define GLIDER_HOOKS_HOOKBEH_BOUNDS_H

#include "hooks/hookbeh/args.h"
#include "hooks/protocol/instruction.h"

GLIDER_HOOKS_BEGIN

/// Checks whether the b_args allow `instruction` (a Take or a Steer): Accepted, or the reason for
/// refusal. Only the numbers that its vertical and lateral parts use are checked. The b_args are
/// rounded to float32 as in the sensor array, so that an instruction with exactly the greatest
/// depth passes.
HookAnswer hookbehCheckBounds(const HookInstruction* instruction, const HookbehArgs* args);

GLIDER_HOOKS_END

#endif
