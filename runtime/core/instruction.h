// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/values.h"
#include "runtime/abi/glider_abi.h"

/// From the commands in force to what crosses the hook.
namespace glider::runtime {

/// The command in force as the sensor array holds it: ddmm.mmmm, float32, headings from magnetic
/// north. Control, session and
/// sequence are left open.
hooks::Instruction instructionFor(const GliderContext& context);

/// True if the two command the same, whatever their session, sequence and control.
bool sameCommand(const hooks::Instruction& a, const hooks::Instruction& b);

/// Degrees to ddmm.mmmm, the sign kept.
double degreesMinutesOf(double degrees);

}  // namespace glider::runtime
