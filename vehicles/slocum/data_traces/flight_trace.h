// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "support/trace/trace.h"
#include "vehicles/slocum/data_tables/merge.h"

#include <string>
#include <vector>

namespace glider::slocum {

/// The sensors that flightTrace() uses, as patterns for merge().
std::vector<std::string> flightTraceSensors();

/// The logged flight as a trace, with the columns and units of report/README.md. Each record of
/// flight is a row, and each record of science that has no record of flight within 10 s; so is each
/// of `more_times_s` (since 1970, ascending) during the log that has no record within 10 s. Time 0
/// is the first row. A quantity that was not updated in a record is interpolated between updates at
/// most 5 min apart; a column that is never known is left out. GL5204: no depth is known.
support::Result<support::Trace> flightTrace(const Merged& merged,
                                            const std::vector<double>& more_times_s = {});

}  // namespace glider::slocum
