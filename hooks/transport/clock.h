// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_TRANSPORT_CLOCK_H
#define GLIDER_HOOKS_TRANSPORT_CLOCK_H

/* The SBC's own clock: for link time-outs only. Mission time comes from the vehicle's frames. */

#ifdef __cplusplus
extern "C" {
#endif

typedef struct GliderClock {
  void* self;
  /* Seconds since some fixed moment, never going back. */
  double (*now)(void* self);
} GliderClock;

#ifdef __cplusplus
}
#endif

#endif
