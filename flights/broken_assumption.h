// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/heard_ticks.h"
#include "flights/requirement_watch.h"
#include "ir/core/mission.h"
#include "support/trace/trace.h"

#include <optional>

namespace glider::flights {

/// When a flight breaks an assumption about its start or the current: by the vehicle's own estimate
/// of it, which is made at the surface from the fixes and may be wrong by 0.1 m/s. `start` is the
/// first tick. The state is left empty if the trace does not say it.
std::optional<FlownViolation> breakInTrace(const ir::Assumption& assumption,
                                           const support::Trace& trace, const HeardTick& start);

}  // namespace glider::flights
