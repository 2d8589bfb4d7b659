// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "vehicles/slocum/data_files/data_file.h"
#include "vehicles/slocum/data_files/sensor_lists.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace glider::slocum {

/// True for what readDataFile is meant for, decided by the beginning of the content or by the
/// extension of the name.
bool looksLikeDataFile(const std::filesystem::path& path, std::string_view bytes);

/// Reads a data file. What follows damage is missing from it (DataFile::damage). GL5200: nothing
/// can be read; GL5201, GL5202: its sensor list cannot be; GL9001.
support::Result<DataFile> readDataFile(const std::filesystem::path& path, SensorLists& lists);
/// As the above, with the content of the file in `bytes`.
support::Result<DataFile> decodeDataFile(const std::filesystem::path& path, std::string_view bytes,
                                         SensorLists& lists);

/// The data files in `folder`, by name, in the order of their names; `folder` itself if it is a
/// file. GL9001: there are none.
support::Result<std::vector<std::filesystem::path>> findDataFiles(
    const std::filesystem::path& folder);

}  // namespace glider::slocum
