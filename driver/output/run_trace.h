// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/check/check.h"
#include "support/result.h"

#include <filesystem>

namespace glider::driver {

/// Writes, for each requirement with a counterexample, `folder`/requirement-N/ (N from 1) with
/// trace.json, trace.csv, events.csv and report.html, in one step as for a flight (FlightFolder).
/// Returns these folders.
support::Result<std::vector<std::filesystem::path>> writeRuns(const analysis::CheckedFile& checked,
                                                              const std::filesystem::path& folder);

}  // namespace glider::driver
