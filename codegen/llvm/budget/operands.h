// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/ADT/StringRef.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace glider::codegen {

inline llvm::StringRef refOf(std::string_view text) {
  return {text.data(), text.size()};
}

/// N of "#N" or "$N".
inline std::optional<int64_t> constantOf(llvm::StringRef text) {
  int64_t number = 0;
  const bool right =
      (text.consume_front("#") || text.consume_front("$")) && !text.getAsInteger(0, number);
  return right ? std::optional(number) : std::nullopt;
}

}  // namespace glider::codegen
