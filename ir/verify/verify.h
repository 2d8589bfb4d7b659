// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "support/diagnostics/engine.h"

#include <span>
#include <string_view>

namespace glider::ir {

/// A row of verify_passes.def.
struct VerifyPass {
  std::string_view name;
  std::string_view purpose;
};

/// The checks in the order in which `verify` runs them.
std::span<const VerifyPass> verifyPasses();

/// Checks `mission` (which must be valid) on its pushdown structure, exactly: guards are not
/// interpreted, except those that are always true or always false for any readings of the sensors.
/// Checks by intervals that no variable leaves its range. Reports GL3xxx; the facts are meaningful
/// only if no error was reported. Time and memory are linear in the mission, with two exceptions:
/// the time to report the errors that `always` causes (multiplied by the number of its cases), and
/// missions in which many cases of `always` go to, and many call, states that the same chain of
/// calls contains.
MissionFacts verify(const Mission& mission, support::DiagnosticEngine& diagnostics);

}  // namespace glider::ir
