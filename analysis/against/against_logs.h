// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "report/findings/against.h"
#include "support/result.h"
#include "vehicles/slocum/data_tables/log_files.h"

#include <span>
#include <vector>

namespace glider::analysis {

/// What `mission` would have done with the readings in the data files of one vehicle: each guard on
/// every tick, and the mission as it follows them. C functions and the SBC's own sensors are
/// unknown. `parameters`: a value for each, SI units, degrees. GL5210: no record has a time.
support::Result<report::AgainstLogs> runAgainstLogs(const compiler::Checked& mission,
                                                    const std::vector<slocum::LogFile>& files,
                                                    std::span<const double> parameters);

}  // namespace glider::analysis
