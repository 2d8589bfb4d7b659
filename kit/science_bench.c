// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The science computer of a simulated vehicle, with the example proglet on it, as a program:
//   glidercc sim MISSION --science ./science_bench
// It reads lines from its standard input and answers on its standard output; doubles are 16
// hexadecimal digits of their bits, bytes two each.
//   hello VERSION HASH VIRTUAL   the version of these lines, the hash of the sensors, whether the
//                                vehicle's clock waits for the SBC   -> hello VERSION HASH
//   sensor ID VALUE              a sensor has a new value
//   bytes HEX                    the SBC has sent these
//   closed                       the line to the SBC is closed
//   run TIME                     a cycle of the science computer     -> the four below, then `done`
// Answers to `run`:
//   set ID VALUE                 the proglet sets a sensor
//   bytes HEX                    it sends these to the SBC
//   event KIND TIME A B C D E TEXT
//   view KNOWN TIME STATE DEPTH PHASE

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/numbers.h"
#include "kit/example_proglet.h"

#define GLIDER_DEFINE_DICTIONARY
#include "platforms/slocum_sensors.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kVersion = 1, kMostBytes = 8192, kMostLine = 2 * kMostBytes + 16 };

static double values[GLIDER_MOST_SENSORS];
static bool fresh[GLIDER_MOST_SENSORS];
static uint8_t received[kMostBytes];
static uint32_t received_count, received_at;
static bool is_closed;

static double get(void* self, uint16_t id, bool* is_fresh) {
  (void)self;
  *is_fresh = fresh[id];
  fresh[id] = false;
  return values[id];
}

/// The vehicle keeps what a proglet sets, and tells it as it tells any sensor.
static void set(void* self, uint16_t id, double value) {
  (void)self;
  printf("set %u %016" PRIx64 "\n", (unsigned)id, hookBitsOfDouble(value));
}

static int32_t readSbc(void* self, uint8_t* bytes, uint32_t capacity) {
  const uint32_t there = received_count - received_at;
  const uint32_t count = capacity < there ? capacity : there;
  (void)self;
  memcpy(bytes, received + received_at, count);
  received_at += count;
  return count == 0 && is_closed ? kGliderStreamClosed : (int32_t)count;
}

static int32_t writeSbc(void* self, const uint8_t* bytes, uint32_t count) {
  (void)self;
  if (is_closed) {
    return kGliderStreamClosed;
  }
  if (count > 0) {
    printf("bytes ");
    for (uint32_t i = 0; i < count; ++i) {
      printf("%02x", (unsigned)bytes[i]);
    }
    printf("\n");
  }
  return (int32_t)count;
}

static void fail(const char* why) {
  printf("error %s\n", why);
  exit(2);
}

/// Bytes that do not fit are lost, as in a UART that nobody reads.
static void receive(const char* hex) {
  memmove(received, received + received_at, received_count - received_at);
  received_count -= received_at;
  received_at = 0;
  unsigned byte = 0;
  for (; sscanf(hex, "%2x", &byte) == 1 && received_count < kMostBytes; hex += 2) {
    received[received_count++] = (uint8_t)byte;
  }
}

static void showEvents(void) {
  HookSeatEvent event;
  while (exampleProgletNextEvent(&event)) {
    printf("event %u %016" PRIx64 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " ",
           (unsigned)event.kind, hookBitsOfDouble(event.mission_time_s), event.a, event.b, event.c,
           event.d, event.e);
    for (const char* text = event.text; *text != 0; ++text) {
      printf("%02x", (unsigned)(uint8_t)*text);
    }
    printf("\n");
  }
}

static void run(double time_s) {
  exampleProgletRun(time_s);
  showEvents();
  const HookSbcView* view = exampleProgletSbc();
  printf("view %d %016" PRIx64 " %" PRIu32 " %u %u\ndone\n", view->known ? 1 : 0,
         hookBitsOfDouble(view->mission_time_s), view->state, (unsigned)view->stack_depth,
         (unsigned)view->phase);
}

static void hello(unsigned version, uint32_t hash, int virtual_time) {
  const ExampleBoard board = {{NULL, get, set}, {NULL, readSbc, writeSbc}};
  if (version != kVersion) {
    fail("other lines are spoken: build it with the kit of this glidercc");
  }
  if (hash != gliderDictionary.hash) {
    fail("the vehicle has other sensors");
  }
  for (uint32_t i = 0; i < GLIDER_MOST_SENSORS; ++i) {
    values[i] = hookUnknown();
  }
  exampleProgletBegin(&board, virtual_time != 0);
  exampleProgletStart();
  printf("hello %u %08" PRIx32 "\n", (unsigned)kVersion, gliderDictionary.hash);
}

static void obey(const char* line) {
  unsigned number = 0;
  uint32_t hash = 0;
  int flag = 0;
  uint64_t bits = 0;
  if (sscanf(line, "sensor %u %" SCNx64, &number, &bits) == 2 && number < GLIDER_MOST_SENSORS) {
    values[number] = hookDoubleOf(bits);
    fresh[number] = true;
  } else if (sscanf(line, "run %" SCNx64, &bits) == 1) {
    run(hookDoubleOf(bits));
  } else if (strncmp(line, "bytes ", 6) == 0) {
    receive(line + 6);
  } else if (sscanf(line, "hello %u %" SCNx32 " %d", &number, &hash, &flag) == 3) {
    hello(number, hash, flag);
  } else if (strcmp(line, "closed\n") == 0) {
    is_closed = true;
  } else {
    fail("a line that it does not know");
  }
}

int main(void) {
  static char line[kMostLine];
  while (fgets(line, sizeof line, stdin) != NULL) {
    obey(line);
    fflush(stdout);
  }
  return 0;
}
