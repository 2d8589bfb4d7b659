// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_files/data_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace glider::slocum {

/// What a compressed file holds.
struct Decompressed {
  std::string content;
  std::vector<Damage> damage;  ///< offsets are of the compressed file
  std::vector<size_t> holes;   ///< bytes of the content in front of which a block is missing
};

/// Content above this size is not decompressed, so that a small file cannot fill the memory.
inline constexpr size_t kLargestContent = size_t{256} << 20U;

/// Decompresses a file of blocks: the size in 2 bytes, high byte first, then one LZ4 block. A block
/// that is invalid leaves a hole; of one that is cut off, it returns what can be decompressed.
Decompressed decompress(std::string_view bytes);

/// True if the first block of `bytes` decompresses to something that begins with `text`.
bool firstBlockBeginsWith(std::string_view bytes, std::string_view text);

}  // namespace glider::slocum
