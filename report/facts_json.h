// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <string>

namespace glider::report {

/// What the page knows of a flight beside the trace's rows, events and field: what its mission says
/// about it, and the bottom around it. A JSON object; NaN is null.
std::string factsToJson(const support::Trace& trace);

/// The requirements and assumptions of the mission, and what the flight did, as a JSON list.
std::string promisesToJson(const support::MissionFacts& facts);

}  // namespace glider::report
