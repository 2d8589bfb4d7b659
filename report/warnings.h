// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cstddef>
#include <string>
#include <vector>

namespace glider::report {

/// How many of the SBC's instructions the vehicle refused.
size_t refusedInstructions(const support::Trace& trace);

/// True if there was an SBC and it never had control.
bool wasNeverInControl(const support::Trace& trace);

/// What the reader must know before any figure of the flight: the mission was never in control, was
/// another one, had instructions refused, or had not ended. One sentence each, without a full stop.
std::vector<std::string> flightWarnings(const support::Trace& trace);

}  // namespace glider::report
