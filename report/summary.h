// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <string>

namespace glider::report {

/// A summary of a flight, as plain aligned text of at most 100 columns for a terminal: figures,
/// time in each state, transitions and other events with vehicle time, mission time and reason.
/// Control characters in names are shown as `?`. Ends with a newline.
std::string summarize(const support::Trace& trace);

}  // namespace glider::report
