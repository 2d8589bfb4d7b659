// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "kit/example_behaviour.h"

#include "hooks/protocol/sensors.h"

#define GLIDER_DEFINE_DICTIONARY
#include "platforms/slocum_sensors.h"

static Hookbeh the_hookbeh;  // not on a stack
static ExampleFlight the_flight;

static double valueOf(uint16_t sensor) {
  return the_flight.get(the_flight.self, sensor);
}

static void report(uint16_t sensor, double value) {
  the_flight.set(the_flight.self, sensor, value);
}

void exampleHull(HookHull* hull) {
  hull->greatest_depth_m = GLIDER_HULL_GREATEST_DEPTH_M;
  hull->steepest_pitch_rad = GLIDER_HULL_STEEPEST_PITCH_RAD;
  hull->shallowest_pitch_rad = GLIDER_HULL_SHALLOWEST_PITCH_RAD;
  hull->vertical_rate_m_s = GLIDER_HULL_VERTICAL_RATE_M_S;
  hull->pump_cc = GLIDER_HULL_PUMP_CC;
  hull->fin_rad = GLIDER_HULL_FIN_RAD;
  hull->battery_in = GLIDER_HULL_BATTERY_IN;
}

void exampleBehaviourInit(const ExampleFlight* flight, const HookbehArgs* args) {
  HookHull hull;
  exampleHull(&hull);
  the_flight = *flight;
  hookbehInit(&the_hookbeh, args, &hull);
}

/// The sensor of each word is that of its role.
static void readInstruction(HookInstructionWords* words) {
#define WORD(role, sensor, word, ...) \
  words->word = valueOf(hookSensorOf(&gliderDictionary, kGliderRole##role));
#define CHECK_WORD(role, sensor, word, line) \
  words->word = valueOf(hookSensorOf(&gliderDictionary, kGliderRole##role));
#define LATER_WORD(role, sensor, word, field, line) \
  words->word = valueOf(hookSensorOf(&gliderDictionary, kGliderRole##role));
#include "hooks/protocol/instruction.def"
}

static void readSensors(HookbehInputs* inputs) {
  const uint16_t ctd = GLIDER_SCI_WATER_PRESSURE;
  hookbehNoInputs(inputs);
  inputs->time_s = valueOf(GLIDER_M_PRESENT_SECS_INTO_MISSION);
  inputs->wall_time_s = valueOf(GLIDER_M_PRESENT_TIME);
  inputs->cycle_number = valueOf(GLIDER_M_CYCLE_NUMBER);
  inputs->depth_m = valueOf(GLIDER_M_DEPTH);
  inputs->depth_rate_mps = valueOf(GLIDER_M_DEPTH_RATE);
  inputs->altitude_m = valueOf(GLIDER_M_ALTITUDE);
  inputs->latitude_ddmm = valueOf(GLIDER_M_LAT);
  inputs->longitude_ddmm = valueOf(GLIDER_M_LON);
  inputs->heartbeat = valueOf(GLIDER_SCI_HOOK_HEARTBEAT);
  inputs->commanded_pump_cc = valueOf(GLIDER_C_BALLAST_PUMPED);
  // A pressure that is not new says nothing about now.
  inputs->ctd_bar = the_flight.isFresh(the_flight.self, ctd) ? valueOf(ctd) : hookUnknown();
  inputs->masked = the_flight.masked(the_flight.self);
}

void exampleBehaviourFly(void) {
  HookbehInputs inputs;
  HookbehOutputs outputs;
  readSensors(&inputs);
  readInstruction(&inputs.words);
  hookbehCycle(&the_hookbeh, &inputs, &outputs);
  report(GLIDER_X_HOOK_STATE, outputs.state);
  report(GLIDER_X_HOOK_ANSWER, outputs.answer);
  report(GLIDER_X_HOOK_SEQUENCE, outputs.answered_sequence);
  report(GLIDER_X_HOOK_SESSION, outputs.session);
  report(GLIDER_X_HOOK_GUARD, outputs.guard);
  report(GLIDER_X_HOOK_MASKED, outputs.masked);
  report(GLIDER_X_HOOK_NAP_SECS, outputs.nap_secs);
  if (outputs.commanding) {
    the_flight.command(the_flight.self, &outputs);
  }
}
