// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A flight for hookbeh_costs, in which hookbeh does what costs most: a vehicle in swell of half a
// metre, with a CTD, over a bottom whose echoes end. Its SBC commands a dive, a hover, pump and
// battery, and a climb; a guard steps in near the bottom.

#include "hooks/hookbeh/hookbeh.h"
#include "platforms/slocum_sensors.h"

enum { kCycles = 130, kStepSecs = 4 };

static const double kBottomM = 40;
static const double kSwellM = 0.3;
static const double kMps = 0.25;

typedef struct Vehicle {
  double depth_m;
  double rate_mps;
  double swell;  ///< of the sine and the cosine of its phase
  double swell_before;
} Vehicle;

/// By the pump, at most to the bottom.
static void move(Vehicle* vehicle, double pump_cc) {
  const double wanted = pump_cc > 100 ? -kMps : pump_cc < -100 ? kMps : pump_cc / -1000;
  vehicle->rate_mps += (wanted - vehicle->rate_mps) * 0.4;
  vehicle->depth_m = hookBetween(vehicle->depth_m + vehicle->rate_mps * kStepSecs, 0, kBottomM);
  const double next = -1.6 * vehicle->swell - vehicle->swell_before;  // a wave of 10 s
  vehicle->swell_before = vehicle->swell;
  vehicle->swell = next;
}

static void instruct(HookbehInputs* inputs, uint16_t sequence, HookVertical vertical,
                     double depth_m, double pitch_rad) {
  HookInstruction instruction = {1,
                                 sequence,
                                 sequence == 1 ? kHookControlTake : kHookControlSteer,
                                 vertical,
                                 kHookLateralHeading,
                                 depth_m,
                                 pitch_rad,
                                 1,
                                 0,
                                 0};
  hookWordsOf(&instruction, &inputs->words);
}

static void command(HookbehInputs* inputs, int cycle) {
  switch (cycle) {
    case 2:
      instruct(inputs, 1, kHookVerticalDescend, 32, -0.45);
      break;
    case 45:
      instruct(inputs, 2, kHookVerticalHover, 32, 0);
      break;
    case 70:
      instruct(inputs, 3, kHookVerticalActuators, -230, 0.5);
      break;
    case 100:
      instruct(inputs, 4, kHookVerticalAscend, 5, 0.45);
      break;
    default:
      break;
  }
}

static void sense(const Vehicle* vehicle, int cycle, HookbehInputs* inputs) {
  const double measured_m = hookAtLeast(vehicle->depth_m + kSwellM * vehicle->swell, 0);
  inputs->time_s = inputs->wall_time_s = kStepSecs * (double)cycle;
  inputs->cycle_number = cycle;
  inputs->depth_m = measured_m;
  inputs->depth_rate_mps = vehicle->rate_mps;
  // It receives no echo from 20 m or more, and none in the last third.
  const bool receives = cycle < kCycles * 2 / 3 && kBottomM - vehicle->depth_m < 20;
  inputs->altitude_m = receives ? kBottomM - measured_m : inputs->altitude_m;
  inputs->ctd_bar = (measured_m + 0.01) / 10;
  inputs->latitude_ddmm = 3910 + 0.002 * cycle;
  inputs->longitude_ddmm = -7350;
  inputs->heartbeat = cycle + 1;
}

int main(void) {
  static const HookHull kHull = {GLIDER_HULL_GREATEST_DEPTH_M,
                                 GLIDER_HULL_STEEPEST_PITCH_RAD,
                                 GLIDER_HULL_SHALLOWEST_PITCH_RAD,
                                 GLIDER_HULL_VERTICAL_RATE_M_S,
                                 GLIDER_HULL_PUMP_CC,
                                 GLIDER_HULL_FIN_RAD,
                                 GLIDER_HULL_BATTERY_IN};
  static Hookbeh hookbeh;
  HookbehArgs args;
  HookbehInputs inputs;
  HookbehOutputs outputs;
  hookbehUsualArgs(&args);
  args.greatest_depth_m = 100;
  hookbehInit(&hookbeh, &args, &kHull);
  hookbehNoInputs(&inputs);
  Vehicle vehicle = {1, 0, 1, 0};
  double pump_cc = 230;
  unsigned done = 0;  // one bit for each thing that it did
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    move(&vehicle, pump_cc);
    sense(&vehicle, cycle, &inputs);
    command(&inputs, cycle);
    hookbehCycle(&hookbeh, &inputs, &outputs);
    pump_cc = outputs.commanding ? outputs.pump_cc : 230;
    done |= 1U << outputs.doing;
  }
  // Unless it has dived, hovered, held a pump and climbed, also for a guard, its cost says nothing.
  const unsigned wanted = 1U << kHookDoingDiveTo | 1U << kHookDoingHover |
                          1U << kHookDoingActuators | 1U << kHookDoingClimbTo |
                          1U << kHookDoingNearBottom;
  return (done & wanted) == wanted ? 0 : 1;
}
