// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/sub_behaviours.h"

#include "hooks/protocol/numbers.h"

static const double kUsualPitchRad = 0.4538;
/// cc; with less, the pump only trims the vehicle (HookDepthWatch).
static const double kFarInCc = 100;

void hookServoCommand(double pitch_rad, double pump_cc, HookDoing doing,
                      HookVerticalCommand* command) {
  command->pitch_rad = pitch_rad;
  command->pump_cc = pump_cc;
  command->doing = doing;
  command->pitch_mode = kHookPitchModeServo;
  command->battery_in = 0;
}

void hookDiveToCommand(const HookSlope* dive, const HookbehArgs* args,
                       HookVerticalCommand* command) {
  hookServoCommand(dive->pitch_rad, args->dive_pump_cc, kHookDoingDiveTo, command);
}

void hookClimbToCommand(const HookSlope* climb, const HookbehArgs* args,
                        HookVerticalCommand* command) {
  hookServoCommand(climb->pitch_rad, args->climb_pump_cc, kHookDoingClimbTo, command);
}

void hookHoldCommand(const HookHold* hold, HookVerticalCommand* command) {
  hookServoCommand(hold->kept.pitch_rad, hold->kept.pump_cc, kHookDoingHold, command);
}

void hookSurfaceCommand(const HookbehArgs* args, HookVerticalCommand* command) {
  hookServoCommand(hookUsualPitch(args), args->climb_pump_cc, kHookDoingSurface, command);
}

bool hookActuatorsDive(const HookFixedActuators* actuators) {
  return actuators->pump_cc <= -kFarInCc;
}

/// What its pitch will be depends on a trim that hookbeh does not know. The guards assume a
/// dive whose pitch is the share of the battery's way, and a vehicle that is never driven up.
void hookActuatorsCommand(const HookFixedActuators* actuators, const HookbehArgs* args,
                          HookVerticalCommand* command) {
  const double share =
      args->greatest_battery_in > 0
          ? hookBetween(hookMagnitude(actuators->battery_in) / args->greatest_battery_in, 0, 1)
          : 0;
  const double steep = hookAtLeast(share * args->steepest_pitch_rad, args->shallowest_pitch_rad);
  command->pitch_rad = hookActuatorsDive(actuators) ? -steep : 0;
  command->pump_cc = actuators->pump_cc;
  command->doing = kHookDoingActuators;
  command->pitch_mode = kHookPitchModeBattery;
  command->battery_in = actuators->battery_in;
}

void hookClimbNow(HookDoing doing, const HookbehArgs* args, const HookHull* hull,
                  HookVerticalCommand* command) {
  hookServoCommand(hookUsualPitch(args), hull->pump_cc, doing, command);
}

double hookUsualPitch(const HookbehArgs* args) {
  return hookBetween(kUsualPitchRad, args->shallowest_pitch_rad, args->steepest_pitch_rad);
}
