// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/dialect.h"

glider::runtime::FrameLine glider::runtime::framesOver(const GliderByteStream& line,
                                                       const LinkFacts* /*checkpoint*/) {
  return {line, nullptr};
}

bool glider::runtime::mayEnd() {
  return true;
}
