// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdio>
#include <cstdlib>

/// Aborts with the location and `message` when `condition` is false: for our own bugs only, never
/// for a pilot's error (a diagnostic) or an I/O or system error (a Result).
#define CHECK(condition, message)                                                              \
  do {                                                                                         \
    if (!(condition)) {                                                                        \
      std::fprintf(stderr, "glidercc: internal error at %s:%d: %s (%s)\n", __FILE__, __LINE__, \
                   message, #condition);                                                       \
      std::abort();                                                                            \
    }                                                                                          \
  } while (false)
