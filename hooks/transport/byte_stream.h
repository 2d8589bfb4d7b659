// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_TRANSPORT_BYTE_STREAM_H
#define GLIDER_HOOKS_TRANSPORT_BYTE_STREAM_H

#include <stdint.h>

/* The one way bytes enter and leave a program on board: plain C, so that a mission, a hook and a
   host program built by different compilers can share it. Implementations: memory.h, termios.h,
   host/. */

#ifdef __cplusplus
extern "C" {
#endif

/* Negative results of read and write. */
enum GliderStreamStatus {
  kGliderStreamClosed = -1, /* the other end has gone; it may come back only through a new stream */
  kGliderStreamFailed = -2  /* the device reported an error */
};

typedef struct GliderByteStream {
  void* self;
  /* Takes up to `capacity` bytes that are there now. Returns how many, 0 for none yet, or a status.
   * Never blocks. */
  int32_t (*read)(void* self, uint8_t* bytes, uint32_t capacity);
  /* Hands over up to `count` bytes. Returns how many were taken (0: no room now), or a status.
   * Never blocks. */
  int32_t (*write)(void* self, const uint8_t* bytes, uint32_t count);
} GliderByteStream;

#ifdef __cplusplus
}
#endif

#endif
