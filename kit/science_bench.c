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

/// The bits of a double in two halves: the C library of a small computer may have no numbers of 64
/// bits in printf and scanf.
static void showNumber(double value) {
  const uint64_t bits = hookBitsOfDouble(value);
  printf("%08lx%08lx", (unsigned long)(bits >> 32U), (unsigned long)(bits & UINT32_MAX));
}

static double numberOf(unsigned long high, unsigned long low) {
  return hookDoubleOf((uint64_t)high << 32U | low);
}

/// The vehicle keeps what a proglet sets, and tells it as it tells any sensor.
static void set(void* self, uint16_t id, double value) {
  (void)self;
  printf("set %u ", (unsigned)id);
  showNumber(value);
  printf("\n");
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

/// The simulated SBC does not sleep.
static void wantSbc(void* self, bool wanted) {
  (void)self;
  (void)wanted;
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
    printf("event %u ", (unsigned)event.kind);
    showNumber(event.mission_time_s);
    printf(" %lu %lu %lu %lu %lu ", (unsigned long)event.a, (unsigned long)event.b,
           (unsigned long)event.c, (unsigned long)event.d, (unsigned long)event.e);
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
  printf("view %d ", view->known ? 1 : 0);
  showNumber(view->mission_time_s);
  printf(" %lu %u %u\ndone\n", (unsigned long)view->state, (unsigned)view->stack_depth,
         (unsigned)view->phase);
}

static void hello(unsigned version, unsigned long hash, int virtual_time) {
  const ExampleBoard board = {{NULL, get, set}, {NULL, readSbc, writeSbc}, wantSbc};
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
  printf("hello %u %08lx\n", (unsigned)kVersion, (unsigned long)gliderDictionary.hash);
}

static void obey(const char* line) {
  unsigned number = 0;
  unsigned long hash = 0, high = 0, low = 0;
  int flag = 0;
  if (sscanf(line, "sensor %u %8lx%8lx", &number, &high, &low) == 3 &&
      number < GLIDER_MOST_SENSORS) {
    values[number] = numberOf(high, low);
    fresh[number] = true;
  } else if (sscanf(line, "run %8lx%8lx", &high, &low) == 2) {
    run(numberOf(high, low));
  } else if (strncmp(line, "bytes ", 6) == 0) {
    receive(line + 6);
  } else if (sscanf(line, "hello %u %lx %d", &number, &hash, &flag) == 3) {
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
