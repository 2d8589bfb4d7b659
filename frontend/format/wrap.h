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

/// A token or comment of a line, with what may stand before it.
struct Piece {
  enum class Role : uint8_t {
    Word,
    Opener,      ///< a bracket
    ListOpener,  ///< one whose items stand on lines of their own
    Closer,
    Comma,
    Remark,  ///< a comment about what stands before it on its line
  };
  std::string text;
  size_t blanks = 0;        ///< before it
  int rank = kNoBreak;      ///< the line may be broken before it; where this is least, first
  bool must_break = false;  ///< the line is broken before it
  Role role = Role::Word;
};

/// The lines that `pieces` make, the first at column `indent` (which it does not hold). `hang` is
/// the column where a line goes on outside brackets; within one it goes on below its first item.
std::vector<std::string> wrap(std::vector<Piece> pieces, size_t indent, size_t hang);

}  // namespace glider::frontend::formatting
