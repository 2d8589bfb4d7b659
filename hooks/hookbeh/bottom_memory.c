// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bottom_memory.h"

#include "hooks/protocol/numbers.h"

/// m; up to this distance the bottom counts as known. Beyond, it may be deeper by kEases metres a
/// metre: shelves slope by less, so that the vehicle finds the bottom again before it is far below
/// it.
static const double kNearM = 3000;
static const double kEases = 0.01;
/// m/s; no position is farther away than the vehicle can have come, currents included.
static const double kDriftMps = 1.5;
/// m; places nearer to each other than this are one.
static const double kSameM = 500;
/// Where the bottom rose on the way to a place, it may rise on by this much more steeply, up to
/// this share of its depth.
static const double kSteeper = 1.5;
static const double kMostRise = 0.5;
/// So much more steeply it rose from where the dive before a contact went: the bottom was deeper
/// there than that dive.
static const double kDeeper = 2;
/// s; so long a shallow bottom is remembered.
static const double kShallowSecs = 1800;
/// m and m per m; from nearer positions no slope is known, and none is steeper.
static const double kLeastApartM = 30;
static const double kSteepest = 0.5;

static void clearPlace(HookBottomPlace* place) {
  place->at.latitude_ddmm = place->at.longitude_ddmm = hookUnknown();
  place->depth_m = kHookBottomless;
  place->rise = place->age_s = place->distance_m = 0;
  place->touched = false;
}

void hookBottomMemoryInit(HookBottomMemory* memory) {
  for (int i = 0; i < kHookBottomPlaces; ++i) {
    clearPlace(&memory->places[i]);
  }
  clearPlace(&memory->dive);
  memory->here = memory->dive.at;
}

static double farFrom(const HookBottomPlace* place, HookPosition now) {
  return hookAtMost(hookDistanceBetween(now, place->at), kDriftMps * place->age_s);
}

void hookBottomMemoryObserve(HookBottomMemory* memory, HookPosition now, double shallow_m,
                             double step_s) {
  memory->here = now;
  for (int i = 0; i < kHookBottomPlaces; ++i) {
    HookBottomPlace* place = &memory->places[i];
    place->age_s += step_s;
    // The first position known after a contact without one is its place, as nearly as can be.
    place->at = hookIsPositionKnown(place->at) ? place->at : now;
    place->distance_m = farFrom(place, now);
    if (place->depth_m <= shallow_m && place->age_s > kShallowSecs) {
      clearPlace(place);
    }
  }
  memory->dive.age_s += step_s;
  memory->dive.distance_m = farFrom(&memory->dive, now);
}

void hookBottomMemoryNoteDive(HookBottomMemory* memory, double depth_m) {
  clearPlace(&memory->dive);
  memory->dive.at = memory->here;
  memory->dive.depth_m = depth_m;
}

static bool isEmpty(const HookBottomPlace* place) {
  return !hookIsFloorKnown(place->depth_m);
}

/// How steeply the bottom rises from there to `other_m` here, m per m; 0 if it falls, or if the two
/// are too near to each other to tell.
static double riseTo(const HookBottomPlace* place, double other_m) {
  const bool rises =
      place->distance_m >= kLeastApartM && place->distance_m <= kNearM && !isEmpty(place);
  return rises ? hookBetween((place->depth_m - other_m) / place->distance_m, 0, kSteepest) : 0;
}

/// The place of that kind that is the same as this one, an empty one, or the farthest.
static HookBottomPlace* placeHere(HookBottomMemory* memory, bool touched) {
  HookBottomPlace* best = &memory->places[0];
  for (int i = 0; i < kHookBottomPlaces; ++i) {
    HookBottomPlace* place = &memory->places[i];
    if (!isEmpty(place) && place->touched == touched && place->distance_m <= kSameM) {
      return place;
    }
    if (!isEmpty(best) && (isEmpty(place) || place->distance_m > best->distance_m)) {
      best = place;
    }
  }
  clearPlace(best);
  return best;
}

static void addPlace(HookBottomMemory* memory, double depth_m, double rise, bool touched) {
  HookBottomPlace* place = placeHere(memory, touched);
  place->at = hookIsPositionKnown(memory->here) ? memory->here : place->at;
  place->depth_m = hookAtMost(place->depth_m, depth_m);
  place->rise = hookAtLeast(rise, place->rise);
  place->age_s = place->distance_m = 0;
  place->touched = touched;
}

void hookBottomMemoryTouch(HookBottomMemory* memory, double depth_m) {
  // Where the dive before went, the bottom was deeper still.
  double rise = kDeeper * riseTo(&memory->dive, depth_m);
  for (int i = 0; i < kHookBottomPlaces; ++i) {
    const HookBottomPlace* place = &memory->places[i];
    rise = place->touched ? hookAtLeast(riseTo(place, depth_m), rise) : rise;
  }
  addPlace(memory, depth_m, hookAtMost(rise, kSteepest), true);
}

void hookBottomMemoryKeepEcho(HookBottomMemory* memory, double depth_m) {
  addPlace(memory, depth_m, 0, false);
}

void hookBottomMemoryForgetEchoes(HookBottomMemory* memory) {
  for (int i = 0; i < kHookBottomPlaces; ++i) {
    if (!memory->places[i].touched) {
      clearPlace(&memory->places[i]);
    }
  }
}

double hookBottomMemoryFloor(const HookBottomMemory* memory, bool touched) {
  double floor_m = kHookBottomless;
  for (int i = 0; i < kHookBottomPlaces; ++i) {
    const HookBottomPlace* place = &memory->places[i];
    if (!isEmpty(place) && (place->touched || !touched)) {
      const double near_m = hookAtMost(place->distance_m, kNearM);
      const double risen = hookAtMost(kSteeper * place->rise * near_m, kMostRise * place->depth_m);
      const double eased = kEases * (place->distance_m - near_m);
      floor_m = hookAtMost(place->depth_m - risen + eased, floor_m);
    }
  }
  return floor_m;
}

double hookBottomMemoryTouchedHere(const HookBottomMemory* memory) {
  double depth_m = hookUnknown();
  double nearest_m = kSameM;
  for (int i = 0; i < kHookBottomPlaces; ++i) {
    const HookBottomPlace* place = &memory->places[i];
    if (place->touched && place->distance_m <= nearest_m) {
      nearest_m = place->distance_m;
      depth_m = place->depth_m;
    }
  }
  return depth_m;
}
