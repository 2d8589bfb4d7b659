// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_RUNTIME_H
#define GLIDER_RUNTIME_ABI_RUNTIME_H

/* The event runtime as a plain C interface: what a board's main program, the in-process driver and
   the test oracles of generated code call. A host shared object of a mission exports what
   entry_points.def lists, and `gliderMission`.

   All memory is the caller's; nothing here allocates, blocks or touches the operating system. */

#include "hooks/transport/byte_stream.h"
#include "hooks/transport/clock.h"
#include "runtime/abi/glider_abi.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct GliderRuntime GliderRuntime;

/* One sensor of a frame, in the vehicle's unit. */
struct GliderUpdate {
  double value;
  uint32_t id; /* number in the platform file */
  uint32_t reserved;
};

/* Where the mission log goes. */
typedef struct GliderLogSink {
  void* self;
  /* Takes the bytes of whole records; returns how many were taken. Fewer, or a negative number, is
     a failure: it is counted and never stops the mission. NULL: there is no log. */
  int32_t (*write)(void* self, const uint8_t* bytes, uint32_t count);
  /* Returns when everything written would survive a power cut: 0, or a negative number if it would
     not. May be NULL. */
  int32_t (*sync)(void* self);
  /* Called after each write: 1 if the log was full and the next write begins a new one; else 0.
     May be NULL: the log has no size limit. */
  int32_t (*renew)(void* self);
} GliderLogSink;

/* Where checkpoints are kept: a file. Data that a power cut could have damaged is never trusted.
   Each function returns how many bytes it processed (sync: 0), or a negative number; a failure
   never stops the mission. */
typedef struct GliderStore {
  void* self;
  /* Beyond its end a store has no bytes. */
  int32_t (*read)(void* self, uint32_t offset, uint8_t* bytes, uint32_t count);
  int32_t (*write)(void* self, uint32_t offset, const uint8_t* bytes, uint32_t count);
  /* Returns when everything written would survive a power cut. */
  int32_t (*sync)(void* self);
} GliderStore;

typedef struct GliderRuntimeOptions {
  GliderLogSink log;
  const double* parameters; /* as gliderStart's; outlives the runtime */
  GliderStore checkpoints;  /* all NULL: none are kept, and each start is from the beginning */
  uint32_t program;         /* identifies this program: checkpoints of another are not used */
} GliderRuntimeOptions;

typedef enum GliderRuntimeStatus {
  kGliderRuntimeIdle,       /* no whole frame is there: wait for bytes, or for the clock */
  kGliderRuntimeProgressed, /* a frame, or a tick of the clock alone, was processed: poll again */
  kGliderRuntimeFinished,   /* the mission has ended and control is released */
  kGliderRuntimeLinkClosed, /* the stream's other end has gone */
  kGliderRuntimeFailed      /* a check of the runtime's own memory failed: from now on it answers no
                               frame, and no      poll does anything */
} GliderRuntimeStatus;

#define ENTRY_POINT(result, name, parameters) result name parameters;

/* gliderRuntimeSize: bytes of memory that gliderRuntimeInit needs, aligned for a double.

   gliderRuntimeInit: makes a runtime in `memory` that waits for control of the vehicle.
   `context_memory` holds mission->context_bytes, aligned for a double; `options` may be NULL.
   Returns NULL if the mission was built for another ABI, has an inconsistent description, or
   subscribes to more sensors than the link carries.

   gliderRuntimePoll: handles at most one frame of the vehicle, or, after 12 s of silence by
   `clock`, a tick of the clock alone. Never blocks.

   gliderRuntimeContext: the running mission's state, for tests and displays; NULL before control
   was given, and after kGliderRuntimeFailed.

   gliderRuntimeFailedCheck: the number of the first check of its own memory that failed
   (runtime/log/checks.def); 0: none.

   gliderStart, gliderStep: the tick of ir/README.md with no link and no log: pure and
   deterministic. gliderStart makes the context in `context_memory` and runs the start with the
   frame in which control was given. `parameters` holds parameter_count values within their ranges,
   SI units; NULL: the defaults. A mission time smaller than the last counts as that. */
#include "runtime/abi/entry_points.def"
#undef ENTRY_POINT

/* The function of a GliderCompass (glider_abi.h). */
GliderConvertHeadings gliderConvertHeadings;
/* The same in a mission that receives others, one without headings and one with them. They first
   add to a frame's updates what has been received since the last one (GliderReading's `waiting`),
   as far as there is room (kMostSubscriptions of the protocol). */
GliderConvertHeadings gliderHear;
GliderConvertHeadings gliderHearAndConvertHeadings;
/* GliderPoll of what is received: NaN. It comes with a frame. */
double gliderNothingHeard(double mission_time);

#ifdef __cplusplus
}
#endif

#endif
