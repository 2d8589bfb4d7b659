// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "kit/example_proglet.h"

#define GLIDER_DEFINE_DICTIONARY
#include "platforms/slocum_sensors.h"

static Hookprog the_hookprog;  // 30 KB: not on a stack
static ExampleBoard the_board;
static bool is_on;

void exampleProgletBegin(const ExampleBoard* board, bool virtual_time) {
  HookSeatOptions options = {0};
  options.virtual_time = virtual_time;
  the_board = *board;
  is_on = false;
  hookprogInit(&the_hookprog, &gliderDictionary, &options);
}

void exampleProgletStart(void) {
  is_on = true;
}

void exampleProgletRun(double science_time_s) {
  if (is_on) {
    hookprogRun(&the_hookprog, science_time_s, &the_board.memory, &the_board.sbc);
    // As a level: a change that was missed is made up for within a second.
    the_board.want_sbc(the_board.memory.self, hookprogWantsSbc(&the_hookprog));
  }
}

void exampleProgletEnd(void) {
  is_on = false;
  the_board.want_sbc(the_board.memory.self, true);  // hookprog would not wake it
}

bool exampleProgletNextEvent(HookSeatEvent* event) {
  return hookprogNextEvent(&the_hookprog, event);
}

const HookSbcView* exampleProgletSbc(void) {
  return &the_hookprog.seat.view;
}
