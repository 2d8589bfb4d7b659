// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"
#include "vehicles/slocum/data_tables/merge.h"

#include <string>
#include <vector>

namespace glider::slocum {

/// The sensors that addEvents() uses.
std::vector<std::string> eventSensors();

/// Adds what happened to `trace`, whose rows and log are complete, in the order of time: segments
/// begin, the vehicle dives and surfaces, reaches waypoints, ends its mission or aborts it.
void addEvents(const Merged& merged, support::Trace& trace);

/// What a code of the mission status means: "overdepth"; "" for one whose meaning is not public.
std::string missionStatusText(int code);

}  // namespace glider::slocum
