// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_files/blocks.h"

#include <array>
#include <lz4.h>
#include <memory>

namespace glider::slocum {
namespace {

constexpr size_t kSizeBytes = 2;
constexpr size_t kMostDamage = 50;       // a file with more is not worth reading on
constexpr size_t kLargestBlock = 65536;  // after decompression; the vehicle's have 32768 bytes

/// The block at `position`: its compressed bytes, fewer than its size says if the file is cut off.
struct Block {
  std::string_view bytes;
  bool whole = false;
};

Block blockAt(std::string_view bytes, size_t position) {
  const std::string_view rest = bytes.substr(position);
  if (rest.size() < kSizeBytes) {
    return {{}, false};
  }
  const size_t size =
      static_cast<size_t>(static_cast<uint8_t>(rest[0])) << 8U | static_cast<uint8_t>(rest[1]);
  return {rest.substr(kSizeBytes, size), rest.size() - kSizeBytes >= size};
}

/// Bytes that `block` decompresses to if only the first `wanted` are; negative: it cannot be done.
int decompressPart(std::string_view block, std::array<char, kLargestBlock>& out, size_t wanted) {
  return LZ4_decompress_safe_partial(block.data(), out.data(), static_cast<int>(block.size()),
                                     static_cast<int>(wanted), static_cast<int>(out.size()));
}

/// How much of a block that is cut off can be decompressed; it is in `out` then.
size_t decompressCut(std::string_view block, std::array<char, kLargestBlock>& out) {
  size_t good = 0;
  for (size_t step = kLargestBlock / 2; step > 0; step /= 2) {
    const size_t wanted = good + step;
    if (decompressPart(block, out, wanted) == static_cast<int>(wanted)) {
      good = wanted;
    }
  }
  return good > 0 && decompressPart(block, out, good) == static_cast<int>(good) ? good : 0;
}

}  // namespace

Decompressed decompress(std::string_view bytes) {
  Decompressed result;
  auto out = std::make_unique<std::array<char, kLargestBlock>>();
  for (size_t position = 0; position < bytes.size();) {
    const Block block = blockAt(bytes, position);
    if (!block.whole) {
      result.content.append(out->data(), decompressCut(block.bytes, *out));
      result.damage.push_back({bytes.size(), "the file ends within a compressed block"});
      break;
    }
    const int size =
        LZ4_decompress_safe(block.bytes.data(), out->data(), static_cast<int>(block.bytes.size()),
                            static_cast<int>(out->size()));
    if (size < 0) {
      result.damage.push_back({position, "the compressed block is invalid"});
      result.holes.push_back(result.content.size());
    } else if (result.content.size() + static_cast<size_t>(size) > kLargestContent) {
      result.damage.push_back({position, "the decompressed content is too large"});
      break;
    } else {
      result.content.append(out->data(), static_cast<size_t>(size));
    }
    if (result.damage.size() >= kMostDamage) {
      break;
    }
    position += kSizeBytes + block.bytes.size();
  }
  return result;
}

bool firstBlockBeginsWith(std::string_view bytes, std::string_view text) {
  auto out = std::make_unique<std::array<char, kLargestBlock>>();
  const Block block = blockAt(bytes, 0);
  return decompressPart(block.bytes, *out, text.size()) == static_cast<int>(text.size()) &&
         std::string_view(out->data(), text.size()) == text;
}

}  // namespace glider::slocum
