// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/format/tokens.h"

#include <cstddef>
#include <vector>

/// Where the lines of a mission begin.
namespace glider::frontend::formatting {

inline constexpr size_t kIndent = 2;     ///< columns of one level
inline constexpr size_t kColumns = 100;  ///< the longest line

/// The content of one line unless that would be too long.
struct Line {
  size_t first = 0;  ///< its tokens, [first, end)
  size_t end = 0;
  size_t indent = 0;          ///< columns
  size_t comment_indent = 0;  ///< of the comments on lines of their own before it
  bool apart = false;         ///< there must be a blank line before it
};

/// The lines of a file in order; the last one holds the empty token at the end.
std::vector<Line> layOut(const std::vector<Token>& tokens);

/// Code points of UTF-8 text.
size_t width(std::string_view text);

}  // namespace glider::frontend::formatting
