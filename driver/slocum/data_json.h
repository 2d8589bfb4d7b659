// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/json_document.h"
#include "vehicles/slocum/data_tables/log_files.h"

#include <string>
#include <vector>

namespace glider::driver {

/// Adds the files of each vehicle, and its sensors that match `patterns` (all if there are none)
/// with their updates, least, greatest and last value.
void putVehicles(Json& document, const std::vector<std::vector<slocum::LogFile>>& vehicles,
                 const std::vector<std::string>& patterns);

}  // namespace glider::driver
