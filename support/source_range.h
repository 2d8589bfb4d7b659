// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace glider::support {

/// A range of a source file in bytes, [begin, end). The default range is "nowhere".
struct SourceRange {
  static constexpr uint32_t kNoFile = UINT32_MAX;
  uint32_t file = kNoFile;
  uint32_t begin = 0;
  uint32_t end = 0;

  [[nodiscard]] bool valid() const { return file != kNoFile; }
  bool operator==(const SourceRange&) const = default;
};

}  // namespace glider::support
