// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "support/trace/trace.h"

#include <filesystem>
#include <string>

namespace glider::driver {

/// Writes report.html, trace.csv and events.csv of a flight into `folder`, which is made if it is
/// not there.
support::Result<void> writeFlight(const support::Trace& trace, const std::filesystem::path& folder);

/// Makes `folder` (and what leads to it) if it is not there. GL9002.
support::Result<void> makeFolder(const std::filesystem::path& folder);

/// The events as CSV: time (s), missiontime (s), kind, what, why; texts in quotes.
std::string eventsToCsv(const support::Trace& trace);

}  // namespace glider::driver
