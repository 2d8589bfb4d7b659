// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glider::support {

struct FixedText {
  std::string text;
  std::vector<Diagnostic> fixed;  ///< those whose fix-its were applied
};

/// `text`, which is file number `file`, with the fix-its of `diagnostics` applied: all of a
/// diagnostic's or none. Of two that touch the same place the first wins; the other has its chance
/// when the result is checked again.
FixedText applyFixes(std::string_view text, uint32_t file,
                     const std::vector<Diagnostic>& diagnostics);

}  // namespace glider::support
