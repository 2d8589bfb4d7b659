// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_files/known_bytes.h"

namespace glider::slocum {
namespace {

// 's', 'a', 0x1234 in 2 bytes, 123.456 in 4, 123456789.12345 in 8.
constexpr std::string_view kBig =
    "\x73\x61\x12\x34\x42\xf6\xe9\x79\x41\x9d\x6f\x34\x54\x7e\x69\xad";
constexpr std::string_view kLittle =
    "\x73\x61\x34\x12\x79\xe9\xf6\x42\xad\x69\x7e\x54\x34\x6f\x9d\x41";
static_assert(kBig.size() == kKnownBytes && kLittle.size() == kKnownBytes);

}  // namespace

std::optional<ByteOrder> byteOrderOf(std::string_view bytes) {
  if (bytes.starts_with(kBig)) {
    return ByteOrder::Big;
  }
  return bytes.starts_with(kLittle) ? std::optional(ByteOrder::Little) : std::nullopt;
}

}  // namespace glider::slocum
