// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_LANGUAGE_H
#define GLIDER_HOOKS_PROTOCOL_LANGUAGE_H

/// What lets one header serve the C99 of the vehicle's software and the C++ of everything else. All
/// names begin with Hook, hook or kHook, or with GLIDER_ for macros; the end of each header gives
/// its types shorter names in namespace glider::hooks of C++.
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
#define GLIDER_HOOKS_BEGIN extern "C" {
#define GLIDER_HOOKS_END }
/// The value that a field has in C++ unless another is given. C sets each field itself.
#define GLIDER_IS(value) = value
#define GLIDER_INLINE inline
#define GLIDER_STATIC_ASSERT(name, condition) static_assert(condition, #name)
#else
#define GLIDER_HOOKS_BEGIN
#define GLIDER_HOOKS_END
#define GLIDER_IS(value)
#define GLIDER_INLINE static inline
#define GLIDER_STATIC_ASSERT(name, condition) typedef char hookAssert##name[(condition) ? 1 : -1]
#endif

/// What the code needs of a compiler: constants above 32767, and doubles that cross the line.
GLIDER_STATIC_ASSERT(IntHas32Bits, sizeof(int) >= 4 && sizeof(uint32_t) == 4);
GLIDER_STATIC_ASSERT(DoubleHas64Bits, sizeof(float) == 4 && sizeof(double) == 8);

#endif
