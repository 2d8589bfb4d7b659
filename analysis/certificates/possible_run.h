// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "support/trace/trace.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// Why no vehicle flies `run` in the environment model of docs/verification.md, under all that the
/// mission assumes: the gaps between its ticks, the ranges of its readings, the vehicle's motion,
/// the error of its depth readings, and the assumptions, in that order for each tick. Empty if one
/// may. The run is checked up to the tick that enters the state which `reach` requires; checkTrace
/// must have passed. `parameters`: SI units, as the run was launched with.
std::string whyImpossible(const support::Trace& run, const compiler::Checked& checked,
                          const std::vector<double>& parameters);

}  // namespace glider::analysis
