// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <string>

namespace glider::report {

/// What the page knows of a flight beside the trace's rows, events and field: what its mission says
/// about it, and the bottom around it. A JSON object; NaN is null.
std::string factsToJson(const support::Trace& trace);

}  // namespace glider::report
