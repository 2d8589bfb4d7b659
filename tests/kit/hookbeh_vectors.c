/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* Whether hookbeh does in each cycle of some flights what its README says: sensor values in,
   commands and reports out. hookbeh_vectors.def has both, from tests/kit/make_vectors. */
#include "hooks/hookbeh/hookbeh.h"
#include "hooks/protocol/bytes.h"
#include "tests/kit/vectors.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* A b_arg or an input of hookbeh: where in its struct the double is, and its bits. */
typedef struct Setting {
  size_t at;
  uint64_t value;
} Setting;
typedef Setting Reading;
#define ARG_AT(name) offsetof(HookbehArgs, name)
#define READ(name) offsetof(HookbehInputs, name)

typedef struct Expected {
  bool commanding, altimeter;
  uint8_t state, answer;
  uint16_t sequence;
  uint32_t session;
  uint8_t guard, masked;
  uint32_t sampling;
  uint8_t doing, heading_mode, pitch_mode;
  uint64_t heading, latitude, longitude, fin, pitch, battery, pump;
} Expected;
typedef struct Cycle {
  Span readings; /* what is new in the sensor array */
  uint8_t masked;
  uint16_t expected;
} Cycle;
typedef struct Flight {
  const char* name;
  bool whole_stroke;
  Span settings, cycles;
} Flight;

#include "tests/kit/hookbeh_vectors.def"

/* A command within this of the expected one is the same: 26 degrees are written as 0.4538 rad. */
static const double kClose = 1e-4;

static void put(void* object, const Setting* setting) {
  const double value = hookDoubleOf(setting->value);
  memcpy((char*)object + setting->at, &value, sizeof value);
}

static bool isClose(double value, uint64_t bits) {
  return hookMagnitude(value - hookDoubleOf(bits)) <= kClose;
}

static void begin(Hookbeh* hookbeh, const Flight* flight) {
  HookbehArgs args;
  hookbehUsualArgs(&args);
  for (uint32_t i = 0; i < flight->settings.count; ++i) {
    put(&args, &kSettings[flight->settings.first + i]);
  }
  if (flight->whole_stroke) {
    args.dive_pump_mode = args.climb_pump_mode = kHookPumpModeAutoballast;
  }
  hookbehInit(hookbeh, &args, &kHull);
}

/* Readings stay in the sensor array until there is another. Clocks, cycle number and heartbeat go
   on by themselves unless there is one. */
static void readSensors(HookbehInputs* inputs, const Cycle* cycle) {
  inputs->time_s += 4;
  inputs->wall_time_s += 4;
  inputs->cycle_number += 1;
  inputs->heartbeat += 1;
  for (uint32_t i = 0; i < cycle->readings.count; ++i) {
    put(inputs, &kReadings[cycle->readings.first + i]);
  }
  inputs->masked = cycle->masked;
}

static void checkReports(const HookbehOutputs* outputs, const Expected* expected, const char* name,
                         uint32_t cycle) {
  want(outputs->state == expected->state, name, "state in cycle", cycle);
  want(outputs->answer == expected->answer, name, "answer in cycle", cycle);
  want(outputs->answered_sequence == expected->sequence, name, "sequence in cycle", cycle);
  want(outputs->session == expected->session, name, "session in cycle", cycle);
  want(outputs->guard == expected->guard, name, "guard in cycle", cycle);
  want(outputs->masked == expected->masked, name, "masked in cycle", cycle);
  want(outputs->doing == expected->doing, name, "what it does in cycle", cycle);
}

static void checkCommands(const HookbehOutputs* outputs, const Expected* expected, const char* name,
                          uint32_t cycle) {
  want(outputs->commanding == expected->commanding, name, "commanding in cycle", cycle);
  want(outputs->altimeter == expected->altimeter, name, "altimeter in cycle", cycle);
  want(outputs->heading_mode == expected->heading_mode &&
           isClose(outputs->heading_rad, expected->heading) &&
           isClose(outputs->latitude_ddmm, expected->latitude) &&
           isClose(outputs->longitude_ddmm, expected->longitude) &&
           isClose(outputs->fin_rad, expected->fin),
       name, "heading or fin in cycle", cycle);
  want(outputs->pitch_mode == expected->pitch_mode &&
           isClose(outputs->pitch_rad, expected->pitch) &&
           isClose(outputs->battery_in, expected->battery),
       name, "pitch in cycle", cycle);
  want(isClose(outputs->pump_cc, expected->pump), name, "pump in cycle", cycle);
  want(outputs->sampling == expected->sampling, name, "instruments in cycle", cycle);
}

static void checkFlight(const Flight* flight) {
  const uint32_t before = differencesSoFar();
  static Hookbeh hookbeh; /* not on a stack */
  HookbehInputs inputs;
  hookbehNoInputs(&inputs);
  inputs.depth_rate_mps = inputs.altitude_m = hookUnknown();
  inputs.latitude_ddmm = inputs.longitude_ddmm = hookUnknown();
  begin(&hookbeh, flight);
  for (uint32_t i = 0; i < flight->cycles.count; ++i) {
    const Cycle* cycle = &kCycles[flight->cycles.first + i];
    HookbehOutputs outputs;
    readSensors(&inputs, cycle);
    hookbehCycle(&hookbeh, &inputs, &outputs);
    checkReports(&outputs, &kExpected[cycle->expected], flight->name, i);
    checkCommands(&outputs, &kExpected[cycle->expected], flight->name, i);
  }
  report(flight->name, flight->cycles.count, before);
}

void checkHookbeh(void) {
  for (uint32_t i = 0; i < COUNT_OF(kFlights); ++i) {
    checkFlight(&kFlights[i]);
  }
}
