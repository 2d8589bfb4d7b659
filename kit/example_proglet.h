// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_KIT_EXAMPLE_PROGLET_H
#define GLIDER_KIT_EXAMPLE_PROGLET_H

/// hookprog as a proglet of a science computer: the four functions that the vehicle's software
/// calls. Yours has these names, or its own; what it calls of the kit is the same.
#include "hooks/hookprog/hookprog.h"

#ifdef __cplusplus
extern "C" {
#endif

/// What the vehicle's software gives a proglet.
typedef struct ExampleBoard {
  HookScienceMemory memory;  ///< its sensors
  GliderByteStream sbc;      ///< the UART to the SBC, 115200 baud, 8N1
  /// Sets the line that switches the SBC on, after each run: false while it may sleep.
  void (*want_sbc)(void* self, bool wanted);
} ExampleBoard;

/// When the science computer starts. `virtual_time`: the vehicle is simulated, and its clock waits
/// for the SBC; false on a vehicle.
void exampleProgletBegin(const ExampleBoard* board, bool virtual_time);
/// When the proglet is switched on: its UART is open from now on.
void exampleProgletStart(void);
/// Once a second; `science_time_s`: a clock that goes on while the computer restarts, such as s
/// since 1970: the heartbeat begins with it.
void exampleProgletRun(double science_time_s);
/// When it is switched off: until it starts again it neither reads nor writes. The SBC is woken,
/// has no answer, and hookbeh takes over after `silence_secs`.
void exampleProgletEnd(void);

/// The oldest event, for the vehicle's log. False when there is none.
bool exampleProgletNextEvent(HookSeatEvent* event);
/// What the SBC has last said of its mission.
const HookSbcView* exampleProgletSbc(void);

#ifdef __cplusplus
}
#endif

#endif
