// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "slocum/data_files/data_file.h"

#include <string_view>

namespace glider::slocum {

/// Decodes the records of `content` from byte `begin` on into `file`, whose header, byte order and
/// columns are known: up to the end mark, the end of the content, or the first damage.
void decodeRecords(std::string_view content, size_t begin, DataFile& file);

}  // namespace glider::slocum
