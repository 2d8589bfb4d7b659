// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/requirement_watch.h"
#include "simulator/ports/sbc_port.h"

namespace glider::flights {

/// Returns what starts the SBC of `flown` (a board's binary, a program) with an SBC in this process
/// beside it, that of `shadow`, which receives the same bytes and whose answers go nowhere: `watch`
/// watches the shadow. When the two report a different time or state of the mission, `watch` is
/// informed (RequirementWatch::depart). `watch` outlives the flight.
simulator::StartSbc shadowed(simulator::StartSbc flown, simulator::StartSbc shadow,
                             RequirementWatch& watch);

}  // namespace glider::flights
