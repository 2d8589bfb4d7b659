// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"
#include "support/result.h"
#include "support/trace/trace.h"

#include <filesystem>
#include <string>
#include <vector>

namespace glider::driver {

/// Writes report.html, trace.csv and events.csv of a flight into `folder`, which is created if it
/// does not exist. `reported` is what went wrong.
support::Result<void> writeFlight(const support::Trace& trace, const std::filesystem::path& folder,
                                  const std::vector<support::Diagnostic>& reported = {});

/// The content of flight.json: which flight this is, whether it went well, the warnings, the
/// figures, and the names of all its files: `files` and flight.json itself.
std::string flightToJson(const support::Trace& trace,
                         const std::vector<support::Diagnostic>& reported,
                         std::vector<std::string> files);

/// Writes flight.json into `folder`.
support::Result<void> writeFlightSummary(const support::Trace& trace,
                                         const std::vector<support::Diagnostic>& reported,
                                         std::vector<std::string> files,
                                         const std::filesystem::path& folder);

/// Creates `folder` and its parents if they do not exist. GL9002.
support::Result<void> makeFolder(const std::filesystem::path& folder);

/// The events as CSV: time (s), missiontime (s), kind, what, why; texts in quotes.
std::string eventsToCsv(const support::Trace& trace);

}  // namespace glider::driver
