// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "simulator/sbc_port.h"
#include "support/result.h"
#include "support/trace/trace.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// What came of a replay.
struct Replayed {
  size_t ticks = 0;     ///< that the SBC answered as the run says
  bool broken = false;  ///< the requirement
  double when = 0;      ///< mission time, s
};

/// Whether `trace` is a run of `mission`: GL9361.
support::Result<void> checkTrace(const support::Trace& trace, const std::string& name,
                                 const compiler::Checked& mission);

/// Flies the run in `trace` on `sbc`, and beside it on the interpreter: GL9362 if they part.
/// The states of what is built from `mission` are called `built_states`. checkTrace has passed.
support::Result<Replayed> replayRun(const support::Trace& trace, const compiler::Checked& mission,
                                    const std::vector<std::string>& built_states,
                                    const std::vector<double>& parameters, simulator::SbcPort& sbc);

}  // namespace glider::analysis
