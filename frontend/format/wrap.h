// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Breaks a line that is too long.
namespace glider::frontend::formatting {

inline constexpr int kNoBreak = -1;

/// A token or comment of a line, with the spaces and breaks allowed before it.
struct Piece {
  enum class Role : uint8_t {
    Word,
    Opener,      ///< a bracket
    ListOpener,  ///< one whose items are on separate lines
    Closer,
    Comma,
    Remark,  ///< a comment about what precedes it on its line
  };
  std::string text;
  size_t blanks = 0;    ///< before it
  int rank = kNoBreak;  ///< the line may be broken before it; breaks with the least rank come first
  bool must_break = false;  ///< the line is broken before it
  Role role = Role::Word;
};

/// The lines of `pieces`, the first at column `indent` (which is not part of it). Outside brackets
/// a line continues at column `hang`; inside a bracket it continues below its first item.
std::vector<std::string> wrap(std::vector<Piece> pieces, size_t indent, size_t hang);

}  // namespace glider::frontend::formatting
