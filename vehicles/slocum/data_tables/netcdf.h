// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "vehicles/slocum/data_tables/merge.h"

#include <filesystem>

namespace glider::slocum {

/// Writes the table to a netCDF-4 file: a variable for each sensor along the dimension `time`, the
/// fill value where a record does not update it. GL9002.
support::Result<void> writeNetcdf(const Merged& merged, const std::filesystem::path& path);

}  // namespace glider::slocum
