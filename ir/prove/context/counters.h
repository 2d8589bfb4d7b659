// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>

namespace glider::ir::prove {

/// The mission with nothing but its counters: in the guards of cases, what reads anything but
/// parameters and variables that are counted up from constants may have any value on each tick.
/// Every trace of the mission is one of the result, which has its states, variables and
/// requirements under the same numbers. None if no guard reads a counter.
std::optional<Mission> onlyCounters(const Mission& mission);

}  // namespace glider::ir::prove
