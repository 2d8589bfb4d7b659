// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_C_LIBRARY_H
#define GLIDER_HOOKS_PROTOCOL_C_LIBRARY_H

/// The functions of the C library that the hooks call, for compilers that come without its headers
/// (freestanding C99 has no string.h). Only for C sources.
#include <stddef.h>

void* memcpy(void* restrict to, const void* restrict from, size_t count);
void* memset(void* at, int byte, size_t count);
int memcmp(const void* one, const void* other, size_t count);

#endif
