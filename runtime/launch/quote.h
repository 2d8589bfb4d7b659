// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/launch/quantity.h"
#include "runtime/log/format.h"

namespace glider::runtime {

/// The longest part of a pilot's text that a message quotes.
inline constexpr uint32_t kMostQuoted = 60;

inline Text& quote(Text& text, const Piece& piece) {
  text.put('`');
  return text.put(piece.begin, piece.size() < kMostQuoted ? piece.size() : kMostQuoted).put('`');
}

}  // namespace glider::runtime
