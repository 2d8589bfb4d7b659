/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

#ifndef GLIDER_BENCH_TICK_PARTS_STREAM_H
#define GLIDER_BENCH_TICK_PARTS_STREAM_H

/* What both sides of bench/tick are fed: depth (m), temperature (degC), pitch (rad). Tables, so
   that the same few instructions are spent on either side. */

enum { kSensors = 3, kPeriod = 8 };

static const double kReadings[2][kSensors][kPeriod] = {
    {{10.0, 10.1, 10.2, 10.3, 10.4, 10.3, 10.2, 10.1},
     {12.5, 12.5, 12.5, 12.5, 12.5, 12.5, 12.5, 12.5},
     {-0.4, -0.4, -0.4, -0.4, -0.4, -0.4, -0.4, -0.4}},
    {{5.0, 30.0, 55.0, 80.0, 95.0, 70.0, 45.0, 20.0},
     {9.0, 12.0, 15.0, 18.0, 19.5, 16.5, 13.5, 10.5},
     {-0.40, -0.20, 0.05, 0.30, 0.40, 0.15, -0.10, -0.30}}};

static double reading(unsigned stream, unsigned sensor, unsigned tick) {
  return kReadings[stream][sensor][tick % kPeriod];
}

static double missionTime(unsigned tick) {
  return 4.0 * tick;
}

static unsigned numberOf(const char* text) {
  unsigned number = 0;
  for (; *text >= '0' && *text <= '9'; ++text) {
    number = 10 * number + (unsigned)(*text - '0');
  }
  return number;
}

#endif
