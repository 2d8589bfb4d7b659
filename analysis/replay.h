// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "simulator/ports/sbc_port.h"
#include "support/result.h"
#include "support/trace/trace.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// The result of a replay.
struct Replayed {
  size_t ticks = 0;     ///< ticks that the SBC answered as the trace says
  bool broken = false;  ///< whether the requirement was violated
  double when = 0;      ///< mission time, s
};

/// Checks that `trace` is a trace of `mission`: GL9361.
support::Result<void> checkTrace(const support::Trace& trace, const std::string& name,
                                 const compiler::Checked& mission);

/// Replays `trace` on `sbc` and in parallel on the interpreter: GL9362 if they differ. The states
/// of what is built from `mission` are called `built_states`. checkTrace must have passed.
support::Result<Replayed> replayRun(const support::Trace& trace, const compiler::Checked& mission,
                                    const std::vector<std::string>& built_states,
                                    const std::vector<double>& parameters, simulator::SbcPort& sbc);

}  // namespace glider::analysis
