// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_tables/log_files.h"

#include <string>
#include <vector>

namespace glider::slocum {

/// The files of one vehicle and their sensors as text for people. `patterns`: the sensors to show.
/// Those that were never updated are shown, with their initial value, if a pattern without `*`
/// names them.
std::string summaryOf(const std::vector<LogFile>& files, const std::vector<std::string>& patterns);

}  // namespace glider::slocum
