// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_files/data_file.h"

#include <expected>
#include <optional>
#include <string_view>

namespace glider::slocum {

/// The header and where it ends.
struct ParsedHeader {
  DataHeader header;
  size_t end = 0;
};

/// Reads the lines at the beginning of `content`.
std::expected<ParsedHeader, Damage> parseHeader(std::string_view content);

/// Seconds since 1970 of a time such as "Fri_Aug__9_12:27:06_2019"; empty if it is not a time.
std::optional<double> timeOf(std::string_view opened);
/// The vehicle's name in "comet-2019-218-0-34"; all of it if it has another form.
std::string vehicleOf(std::string_view full_name);

}  // namespace glider::slocum
