// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdio>
#include <cstdlib>

/// Aborts with the place and `message` when `condition` is false: for our own bugs only, never for
/// a pilot's mistake (a diagnostic) or the world's failure (a Result).
#define CHECK(condition, message)                                                              \
  do {                                                                                         \
    if (!(condition)) {                                                                        \
      std::fprintf(stderr, "glidercc: internal error at %s:%d: %s (%s)\n", __FILE__, __LINE__, \
                   message, #condition);                                                       \
      std::abort();                                                                            \
    }                                                                                          \
  } while (false)
