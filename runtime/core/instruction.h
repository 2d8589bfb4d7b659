// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "runtime/abi/glider_abi.h"

/// Converts the commands in force to the values that cross the hook.
namespace glider::runtime {

/// The command in force as the sensor array holds it: ddmm.mmmm, float32, headings from magnetic
/// north. Control, session and sequence are not set.
hooks::Instruction instructionFor(const GliderContext& context);

/// True if the two command the same; session, sequence and control are ignored.
bool sameCommand(const hooks::Instruction& a, const hooks::Instruction& b);

/// Converts degrees to ddmm.mmmm; keeps the sign.
double degreesMinutesOf(double degrees);

}  // namespace glider::runtime
