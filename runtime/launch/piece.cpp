// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/launch/quantity.h"

#include <string.h>

namespace glider::runtime {
namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

}  // namespace

const char* Piece::find(char c) const {
  const char* place = begin;
  while (place != end && *place != c) {
    ++place;
  }
  return place;
}

Piece Piece::trimmed() const {
  Piece piece = *this;
  while (!piece.empty() && isBlank(*piece.begin)) {
    ++piece.begin;
  }
  while (!piece.empty() && isBlank(piece.end[-1])) {
    --piece.end;
  }
  return piece;
}

bool Piece::is(const char* text) const {
  return strlen(text) == size() && memcmp(begin, text, size()) == 0;
}

}  // namespace glider::runtime
