// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_TALK_MISSION_H
#define GLIDER_RUNTIME_ABI_TALK_MISSION_H

#include <stdint.h>

/* Shares that a message holds, and periods, at most. */
#define GLIDER_MOST_SHARES 32u
/* Frames of the modem that the program fills: 32 bytes, at rate 0. */
#define GLIDER_MOST_MESSAGE_BYTES 32u
#define GLIDER_MINI_PACKET 0u
#define GLIDER_NO_PLACE UINT32_MAX
/* Values that are received from named vehicles, at most: a frame of the vehicle holds no more. */
#define GLIDER_MOST_NAMED 64u

/* A value that the vehicle tells others: one of the numbers lowest + i step, 0 <= i < values. */
typedef struct GliderShare {
  double lowest; /* SI units or degrees */
  double step;
  uint32_t values;
  uint32_t reading;  /* place in the mission's sensors of what is sent, or GLIDER_NO_PLACE: */
  uint32_t variable; /* place in GliderContext::variables */
  uint32_t peer;     /* place in the mission's sensors of what is received, or GLIDER_NO_PLACE */
} GliderShare;

/* What is received of a share from one vehicle. */
typedef struct GliderNamed {
  uint32_t reading; /* place in the mission's sensors */
  uint16_t share;
  uint16_t source; /* the address of that vehicle */
} GliderNamed;

/* The shares of one period: one message. */
typedef struct GliderMessage {
  double period;  /* s */
  uint32_t first; /* share */
  uint32_t count;
  uint32_t signature; /* 0..255: of the names, units, numbers and the period of its shares */
  uint32_t bytes; /* of the packed message: 1..GLIDER_MOST_MESSAGE_BYTES, or GLIDER_MINI_PACKET */
} GliderMessage;

/* What the program on the SBC must know of what the mission tells and receives. The compiler writes
   one into each program of a mission with shares, as `gliderTalk`. No padding: it is the same on
   every board. */
typedef struct GliderTalk {
  double slot_s; /* each vehicle sends at the beginning of its slot, by UTC */
  uint32_t utc;  /* place in the mission's sensors of the vehicle's clock */
  uint32_t share_count;
  uint32_t message_count;
  uint32_t
      begin_within_ms; /* of its slot: a message that was not begun by then waits for the next */
  uint32_t named_count;
  uint32_t vehicle_count; /* whose names the mission knows, by address; 0: it knows none */
  GliderShare shares[GLIDER_MOST_SHARES];
  GliderMessage messages[GLIDER_MOST_SHARES];
  GliderNamed named[GLIDER_MOST_NAMED];
} GliderTalk;

#endif
