// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>

namespace glider::ir {

/// Leaves only what flies: drops the requirements, and the sensors that only they read. Assumptions
/// of the kinds Range, Outage and Always become Mission::every_tick, which leaves one note,
/// `brokenAssumption`, when one is broken for the first time (or, of several on one tick, on the
/// next ticks); the others are dropped.
void prepareForFlight(Mission& mission);

/// The text of that note: "assumption broken: known altitude every 1 min".
std::string brokenAssumption(const Assumption& assumption);

}  // namespace glider::ir
