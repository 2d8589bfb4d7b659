// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/ocean/ocean.h"
#include "support/trace/trace.h"

namespace glider::simulator {

/// The temperature of the water along the track of `trace`, from the surface to a little below the
/// deepest row. `trace` has a row at least.
support::TraceField waterAlong(const support::Trace& trace, const Ocean& ocean);

/// The bottom under the track of `trace` and around it, as far as half the track's extent; empty if
/// it is flat. `trace` has a row at least.
support::BottomGrid bottomAround(const support::Trace& trace, const Ocean& ocean);

}  // namespace glider::simulator
