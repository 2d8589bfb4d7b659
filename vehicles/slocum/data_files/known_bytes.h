// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_files/data_file.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace glider::slocum {

/// The bytes between the sensor list and the records.
inline constexpr size_t kKnownBytes = 16;

/// The byte order in which `bytes` hold the known numbers; empty: they do not.
std::optional<ByteOrder> byteOrderOf(std::string_view bytes);

}  // namespace glider::slocum
