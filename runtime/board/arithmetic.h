// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::runtime {

/// Makes the 486's floating-point unit round each result as a double (53 bits, to nearest, no
/// traps), as every other board does by default. Must be the first call in main, before any
/// arithmetic.
inline void useDoublePrecision() {
#if defined(__i386__)
  const unsigned short control = 0x027F;
  __asm__ volatile("fldcw %0" : : "m"(control));
#endif
}

}  // namespace glider::runtime
