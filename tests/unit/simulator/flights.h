// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/simulator.h"

#include <filesystem>
#include <string>

namespace glider::simulator {

using support::EventId;

/// The project's own scenario `name`, with the Slocum, no SBC. Aborts the test program when they
/// are not right.
SimulationSetup shippedSetup(const std::string& name);
/// The water of layered.toml with `mission` as the text of its mission file.
SimulationSetup setupWith(const std::string& mission);
support::Trace fly(SimulationSetup setup);
/// The first event `id`; null if there is none.
const support::TraceEvent* findEvent(const support::Trace& trace, support::EventId id);
/// The first event whose text contains `text`; null if there is none.
const support::TraceEvent* findEvent(const support::Trace& trace, const std::string& text);
/// The first start of a behaviour called `name`, at any place of the mission; null if there
/// is none.
const support::TraceEvent* findStart(const support::Trace& trace, const std::string& name);
/// All events, a line each, for a failed test.
std::string eventText(const support::Trace& trace);
/// The newest value of `column` at time `time_s`.
double valueAt(const support::Trace& trace, const char* column, double time_s);

}  // namespace glider::simulator
