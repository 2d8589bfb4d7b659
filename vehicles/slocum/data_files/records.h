// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_files/data_file.h"

#include <string_view>
#include <vector>

namespace glider::slocum {

/// Decodes the records of `content` from byte `begin` on into `file`, whose header, byte order and
/// columns are known, up to the end mark or the end of the content. Content is missing at the bytes
/// `holes`. After damage or a hole it goes on with the next bytes that are several records in a row
/// (DataFile::breaks), if there are any. The records before damage that it may have
/// changed are then left out.
void decodeRecords(std::string_view content, size_t begin, const std::vector<size_t>& holes,
                   DataFile& file);

}  // namespace glider::slocum
