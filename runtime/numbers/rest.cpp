// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/numbers/numbers.h"

namespace glider::runtime {

/// Every subtraction is of a number between half the size and the size: exact (Sterbenz). A third
/// of the bytes of fmod, which an SBC's soft floating point makes long.
[[gnu::noinline]] double restOf(double size, double of) {
  if (!isFinite(size)) {
    return unknown();
  }
  double part = of;
  while (part <= size * 0.5) {
    part *= 2.0;
  }
  for (; part >= of; part *= 0.5) {
    if (size >= part) {
      size -= part;
    }
  }
  return size;
}

}  // namespace glider::runtime
