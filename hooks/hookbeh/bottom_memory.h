// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_BOTTOM_MEMORY_H
#define GLIDER_HOOKS_HOOKBEH_BOTTOM_MEMORY_H

#include "hooks/hookbeh/position.h"

GLIDER_HOOKS_BEGIN

/// m; over a bottom as shallow as this no vehicle can dive, for any least altitude.
static const double kHookShallowM = 12;
/// A depth that counts as no bottom at all, m.
static const double kHookBottomless = 1e9;

/// False for a floor at no depth that any sea has.
GLIDER_INLINE bool hookIsFloorKnown(double floor_m) {
  return floor_m < kHookBottomless / 2;
}

typedef struct HookBottomPlace {
  HookPosition at;
  double depth_m;  ///< kHookBottomless: an empty one
  double rise;     ///< m per m, towards other places
  double age_s;
  double distance_m;  ///< from the vehicle, now
  bool touched;
} HookBottomPlace;

enum { kHookBottomPlaces = 8 };

/// Places where the bottom is known although the altimeter did not show it: where the vehicle
/// touched it, and where an altimeter that then failed received its last echo. Memory fades with
/// the distance from the place, not with time: the bottom does not move.
typedef struct HookBottomMemory {
  HookBottomPlace places[kHookBottomPlaces];
  HookBottomPlace dive;  ///< how deep the dive before the newest went, and where
  HookPosition here;
} HookBottomMemory;

void hookBottomMemoryInit(HookBottomMemory* memory);
/// Takes in one cycle: where the vehicle is now. All else concerns this position. Over a touched
/// bottom of less than `shallow_m` it cannot dive, and so not fly away either: after half an hour
/// it tries again.
void hookBottomMemoryObserve(HookBottomMemory* memory, HookPosition now, double shallow_m,
                             double step_s);
/// A dive has turned that went as deep as `depth_m`.
void hookBottomMemoryNoteDive(HookBottomMemory* memory, double depth_m);
/// The vehicle has touched the bottom at `depth_m`. Where the dive before went deeper, or the
/// bottom was deeper at a touched place, it rises on.
void hookBottomMemoryTouch(HookBottomMemory* memory, double depth_m);
/// An altimeter has failed whose last echo showed the bottom at `depth_m`.
void hookBottomMemoryKeepEcho(HookBottomMemory* memory, double depth_m);
/// The altimeter works: what hookBottomMemoryKeepEcho() was given is forgotten.
void hookBottomMemoryForgetEchoes(HookBottomMemory* memory);
/// How deep the bottom is at least, m: by all places, or by the touched ones alone.
double hookBottomMemoryFloor(const HookBottomMemory* memory, bool touched);
/// How deep it was at the nearest place that the vehicle has touched, m; NaN if none is within
/// 500 m.
double hookBottomMemoryTouchedHere(const HookBottomMemory* memory);

GLIDER_HOOKS_END

#endif
