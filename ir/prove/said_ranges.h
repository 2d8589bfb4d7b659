// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_range.h"

#include <cstdint>
#include <map>
#include <utility>

namespace glider::ir::prove {

/// The conditions about which something was reported: nothing is said of one twice. They lie
/// within each other or apart, as conditions do; of those within each other the outermost is kept.
class SaidRanges {
 public:
  void add(const support::SourceRange& range);
  /// Whether the range lies within one of them.
  [[nodiscard]] bool cover(const support::SourceRange& range) const;
  /// Whether the range lies within one of them or has one of them within it.
  [[nodiscard]] bool concern(const support::SourceRange& range) const;

 private:
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> ends_;  ///< by file and beginning
};

}  // namespace glider::ir::prove
