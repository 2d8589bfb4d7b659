// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/findings/against.h"
#include "support/trace/trace.h"

#include <string>

namespace glider::report {

/// Marks in `flight`, the logged flight of the same vehicle, what `mission` would have done with
/// its readings: an event for each change of its state, and for each time that a guard flickers.
void markAgainst(const std::string& mission, const AgainstLogs& against, support::Trace& flight);

}  // namespace glider::report
