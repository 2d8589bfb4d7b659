// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_KIT_EXAMPLE_BEHAVIOUR_H
#define GLIDER_KIT_EXAMPLE_BEHAVIOUR_H

/// hookbeh as a behaviour of the layered control: what the vehicle's software calls when a mission
/// begins and in each control cycle. Yours has these names, or its own.
#include "hooks/hookbeh/hookbeh.h"

#ifdef __cplusplus
extern "C" {
#endif

/// What the vehicle's software gives a behaviour.
typedef struct ExampleFlight {
  void* self;
  /// The value of a sensor in the sensor array; NaN if it was never set.
  double (*get)(void* self, uint16_t sensor);
  /// Whether it was set since the previous cycle.
  bool (*isFresh)(void* self, uint16_t sensor);
  void (*set)(void* self, uint16_t sensor, double value);
  /// kHookMaskedHeading…: what a behaviour above replaced in the previous cycle; 0 if it is not
  /// known.
  uint8_t (*masked)(void* self);
  /// Gives heading, pitch and pump to the layered control, at the behaviour's priority.
  void (*command)(void* self, const HookbehOutputs* outputs);
} ExampleFlight;

/// The limits of the hull, which are built in: no mission file widens them.
void exampleHull(HookHull* hull);
/// When a mission that has the behaviour begins. `args`: its b_args, in the mission file's units;
/// those that it does not name are as hookbehUsualArgs has them.
void exampleBehaviourInit(const ExampleFlight* flight, const HookbehArgs* args);
/// In each control cycle until the mission ends, whether or not another behaviour is above it: it
/// must know the bottom and the depth when it matters. It reports in the sensors `x_hook_…`.
void exampleBehaviourFly(void);

#ifdef __cplusplus
}
#endif

#endif
