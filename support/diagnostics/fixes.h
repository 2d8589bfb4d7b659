// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"
#include "support/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::support {

struct FixedText {
  std::string text;
  std::vector<Diagnostic> fixed;  ///< those whose fix-its were applied
};

/// `text`, which is file number `file`, with the fix-its of `diagnostics` applied: for each
/// diagnostic all of them or none. If two touch the same place, only the first is applied; the
/// other may be applied after the result is checked again.
FixedText applyFixes(std::string_view text, uint32_t file,
                     const std::vector<Diagnostic>& diagnostics);

/// What was done to a text to fix it.
struct Fixing {
  struct Round {
    std::string before;  ///< the text that the locations of `fixed` refer to
    std::vector<Diagnostic> fixed;
  };
  std::vector<Round> rounds;
  std::string text;    ///< after the last round
  bool worse = false;  ///< it has more errors than the original, and must not be kept
};

/// Applies fix-its to `text`, which is file number `file`, round after round until none is left
/// (or for 100 rounds, in case they undo each other). `check` gives the diagnostics of a text. An
/// error counts more than any of a later stage, which it may have hidden: syntax (GL1xxx) before
/// names, types and units (GL2xxx) before all others.
Result<Fixing> fixAll(
    std::string text, uint32_t file,
    const std::function<Result<std::vector<Diagnostic>>(const std::string&)>& check);

}  // namespace glider::support
