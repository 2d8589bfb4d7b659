// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/prove/prove.h"
#include "support/trace/trace.h"

namespace glider::analysis {

/// The counterexample of a requirement, or the trace that `reach` asks for, as the trace of a
/// flight: a row for each tick, with the readings as the vehicle reports them and its true depth.
support::Trace traceOfRun(const compiler::Checked& checked,
                          const ir::prove::RequirementVerdict& verdict);

}  // namespace glider::analysis
