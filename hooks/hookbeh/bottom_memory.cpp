// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bottom_memory.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// m; up to this distance the bottom counts as known. Beyond, it may be deeper by kEases metres a
/// metre: shelves slope by less, so that the vehicle finds the bottom again before it is far below
/// it.
constexpr double kNearM = 3000;
constexpr double kEases = 0.01;
/// m/s; no position is farther away than the vehicle can have come, currents included.
constexpr double kFastestMps = 1.5;
/// m; places nearer to each other than this are one.
constexpr double kSameM = 500;
/// Where the bottom rose on the way to a place, it may rise on by this much more steeply, up to
/// this share of its depth.
constexpr double kSteeper = 1.5;
constexpr double kMostRise = 0.5;
/// m and s; over so shallow a bottom the vehicle cannot dive, so it cannot fly away either: after
/// this time it tries again.
constexpr double kShallowM = 12;
constexpr double kShallowSecs = 1800;
/// m and m per m; from nearer positions no slope is known, and none is steeper.
constexpr double kLeastApartM = 30;
constexpr double kSteepest = 0.5;

}  // namespace

double riseBetween(const Position& from, double from_m, const Position& to, double to_m) {
  const double apart = distanceBetween(from, to);
  const bool rises = apart >= kLeastApartM && from_m > to_m;
  return rises ? atMost((from_m - to_m) / apart, kSteepest) : 0;
}

void BottomMemory::observe(const Position& now, double step_s) {
  for (Place& place : places_) {
    place.age_s += step_s;
    place.distance_m = atMost(distanceBetween(now, place.at), kFastestMps * place.age_s);
    if (place.depth_m <= kShallowM && place.age_s > kShallowSecs) {
      place = {};
    }
  }
}

/// The place that is the same as `at`, an empty one, or the farthest.
BottomMemory::Place& BottomMemory::placeFor(const Position& at) {
  Place* best = &places_[0];
  for (Place& place : places_) {
    if (place.depth_m < kBottomless && distanceBetween(at, place.at) <= kSameM) {
      return place;
    }
    const bool empty = !(place.depth_m < kBottomless);
    const bool best_is_empty = !(best->depth_m < kBottomless);
    if (!best_is_empty && (empty || place.distance_m > best->distance_m)) {
      best = &place;
    }
  }
  *best = {};
  return *best;
}

void BottomMemory::add(const Position& at, double depth_m, double rise, bool touched) {
  Place& place = placeFor(at);
  place = {at,  atMost(place.depth_m, depth_m),  atLeast(rise, place.rise), 0, 0,
           touched || place.touched};
}

void BottomMemory::forgetEchoes() {
  for (Place& place : places_) {
    if (!place.touched) {
      place = {};
    }
  }
}

double BottomMemory::floor() const {
  double floor = kBottomless;
  for (const Place& place : places_) {
    if (place.depth_m < kBottomless) {
      const double near = atMost(place.distance_m, kNearM);
      const double risen =
          atMost(kSteeper * place.rise * near, kMostRise * place.depth_m);
      const double eased = kEases * (place.distance_m - near);
      floor = atMost(place.depth_m - risen + eased, floor);
    }
  }
  return floor;
}

double BottomMemory::touchedHere() const {
  double depth_m = __builtin_nan("");
  double nearest_m = kSameM;
  for (const Place& place : places_) {
    if (place.touched && place.distance_m <= nearest_m) {
      nearest_m = place.distance_m;
      depth_m = place.depth_m;
    }
  }
  return depth_m;
}

double BottomMemory::riseTo(const Position& at, double depth_m) const {
  double rise = 0;
  for (const Place& place : places_) {
    if (place.touched && place.distance_m <= kNearM) {
      rise = atLeast(riseBetween(place.at, place.depth_m, at, depth_m), rise);
    }
  }
  return rise;
}

}  // namespace glider::hooks
