// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/nap_times.h"
#include "ir/core/mission.h"
#include "platforms/load/platform.h"

namespace glider::ir {

/// How much later than at once an SBC acts that has slept, s.
inline constexpr double kNapLag_s = kHookMostWakeSecs + kHookReplaySecs;

/// How far before a depth that it dives or climbs to a vehicle wakes a sleeping SBC, m: so
/// early that in any water the SBC reads its line when the vehicle is there. Two readings may be as
/// far apart as two ticks may be, and each may be wrong.
double napAhead_m(const platforms::Platform& platform);

/// Gives the vehicle the delay with which it obeys a mission that lets the SBC sleep. Each tick of
/// a nap is evaluated with its own mission time and readings, in order, so no decision changes;
/// but what the last one commands has waited for the SBC. Every proof, check and summary of the
/// mission is about that vehicle.
void allowForNaps(const Mission& mission, platforms::EnvironmentModel& world);

}  // namespace glider::ir
