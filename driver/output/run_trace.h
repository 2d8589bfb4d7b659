// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/check_mission.h"
#include "support/result.h"
#include "support/trace/trace.h"

#include <filesystem>

namespace glider::driver {

/// A run that the verifier found, as the trace of a flight: a row each tick, with the readings as
/// the vehicle reports them and its true depth.
support::Trace traceOfRun(const compiler::Checked& checked,
                          const ir::prove::RequirementVerdict& verdict);

/// Writes, for each requirement that a run breaks, `folder`/requirement-N/ (N from 1) with
/// trace.json, trace.csv, events.csv and report.html, all at once as for a flight (FlightFolder).
/// Returns how many.
support::Result<size_t> writeRuns(const CheckedFile& checked, const std::filesystem::path& folder);

}  // namespace glider::driver
