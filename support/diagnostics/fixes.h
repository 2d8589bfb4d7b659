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

/// Where the constructs of a text begin and what holds them together. By default the whole text is
/// one construct.
struct Constructs {
  /// The bytes of a word.
  struct Word {
    uint32_t begin = 0;
    uint32_t end = 0;
  };
  std::vector<uint32_t> items;  ///< declarations and states, in order
  std::vector<uint32_t> parts;  ///< of items: a header, a line of a state, a case; in order
  std::vector<Word> words;      ///< that open, close or separate constructs, in order
  std::vector<std::string> structure = {};  ///< words that do so where a fix writes them
};

struct FixedText {
  std::string text;
  std::vector<Diagnostic> fixed;  ///< those whose fix-its were applied
};

/// `text`, which is file number `file`, with the fix-its of `diagnostics`, in the order of the
/// text, applied: for each diagnostic all of them or none. If two touch the same place, only the
/// first is applied; the other may be applied after the result is checked again. What follows from
/// another error is not changed:
/// - of an error, only if it is the first in its part of the text and its item's header has none;
/// - of a name, type or unit, only if nothing in its part is a syntax error;
/// - if the fix changes the structure, only if it is the first at its place and in its item;
/// - of a warning, only if there is no error.
FixedText applyFixes(std::string_view text, uint32_t file,
                     const std::vector<Diagnostic>& diagnostics, const Constructs& constructs);

/// What was done to a text to fix it.
struct Fixing {
  struct Round {
    std::string before;  ///< the text that the locations of `fixed` refer to
    std::vector<Diagnostic> fixed;
  };
  std::vector<Round> rounds;
  std::string text;      ///< after the last round
  bool refused = false;  ///< a fix was not kept, because it would not leave fewer errors
};

/// Reads a candidate text.
struct FixReader {
  std::function<Result<std::vector<Diagnostic>>(const std::string&)> check;
  std::function<Constructs(const std::string&)> constructs;
};

/// Applies fix-its to `text`, which is file number `file`, round after round until none is left
/// (or for 100 rounds). A fix after which there are not fewer errors is not kept. An error counts
/// more than any of a later stage, which it may have hidden: syntax (GL1xxx) before names, types
/// and units (GL2xxx) before all others.
Result<Fixing> fixAll(std::string text, uint32_t file, const FixReader& reader);

}  // namespace glider::support
