// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "simulator/simulator.h"

namespace glider::flights {

/// Why a transition happened, for events and reports: the source of the guard of case `fired_case`
/// of `list` (hooks::CaseList) in `state` on one line, and the vehicle's sensors that it reads.
/// Empty for numbers that the mission does not have.
simulator::GuardText explainGuard(const compiler::Optimised& of, uint32_t list, uint32_t state,
                                  uint32_t fired_case);

}  // namespace glider::flights
