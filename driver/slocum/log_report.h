// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/slocum/data_log.h"
#include "support/result.h"
#include "vehicles/slocum/data_tables/log_files.h"

#include <vector>

namespace glider::driver {

/// Writes the report page and the picture of the files of one vehicle to where the options say.
support::Result<void> drawLog(const std::vector<slocum::LogFile>& files,
                              const DataLogOptions& options);

}  // namespace glider::driver
