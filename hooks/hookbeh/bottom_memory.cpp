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
constexpr double kDriftMps = 1.5;
/// m; places nearer to each other than this are one.
constexpr double kSameM = 500;
/// Where the bottom rose on the way to a place, it may rise on by this much more steeply, up to
/// this share of its depth.
constexpr double kSteeper = 1.5;
constexpr double kMostRise = 0.5;
/// So much more steeply it rose from where the dive before a contact went: the bottom was deeper
/// there than that dive.
constexpr double kDeeper = 2;
/// s; so long a shallow bottom is remembered.
constexpr double kShallowSecs = 1800;
/// m and m per m; from nearer positions no slope is known, and none is steeper.
constexpr double kLeastApartM = 30;
constexpr double kSteepest = 0.5;

}  // namespace

void BottomMemory::observe(const Position& now, double shallow_m, double step_s) {
  here_ = now;
  for (Place& place : places_) {
    place.age_s += step_s;
    // The first position known after a contact without one is its place, as nearly as can be.
    place.at = isKnown(place.at) ? place.at : now;
    place.distance_m = atMost(distanceBetween(now, place.at), kDriftMps * place.age_s);
    if (place.depth_m <= shallow_m && place.age_s > kShallowSecs) {
      place = {};
    }
  }
  dive_.age_s += step_s;
  dive_.distance_m = atMost(distanceBetween(now, dive_.at), kDriftMps * dive_.age_s);
}

void BottomMemory::noteDive(double depth_m) {
  dive_ = {here_, depth_m, 0, 0, 0, false};
}

/// How steeply the bottom rises from there to `other_m` here, m per m; 0 if it falls, or if the two
/// are too near to each other to tell.
double BottomMemory::Place::riseTo(double other_m) const {
  const bool rises = distance_m >= kLeastApartM && distance_m <= kNearM && !empty();
  return rises ? between((depth_m - other_m) / distance_m, 0, kSteepest) : 0;
}

/// The place of that kind that is the same as this one, an empty one, or the farthest.
BottomMemory::Place& BottomMemory::placeHere(bool touched) {
  Place* best = &places_[0];
  for (Place& place : places_) {
    if (!place.empty() && place.touched == touched && place.distance_m <= kSameM) {
      return place;
    }
    if (!best->empty() && (place.empty() || place.distance_m > best->distance_m)) {
      best = &place;
    }
  }
  *best = {};
  return *best;
}

void BottomMemory::add(double depth_m, double rise, bool touched) {
  Place& place = placeHere(touched);
  place.at = isKnown(here_) ? here_ : place.at;
  place.depth_m = atMost(place.depth_m, depth_m);
  place.rise = atLeast(rise, place.rise);
  place.age_s = place.distance_m = 0;
  place.touched = touched;
}

void BottomMemory::touch(double depth_m) {
  // Where the dive before went, the bottom was deeper still.
  double rise = kDeeper * dive_.riseTo(depth_m);
  for (const Place& place : places_) {
    rise = place.touched ? atLeast(place.riseTo(depth_m), rise) : rise;
  }
  add(depth_m, atMost(rise, kSteepest), true);
}

void BottomMemory::keepEcho(double depth_m) {
  add(depth_m, 0, false);
}

void BottomMemory::forgetEchoes() {
  for (Place& place : places_) {
    if (!place.touched) {
      place = {};
    }
  }
}

double BottomMemory::floor(bool touched) const {
  double floor = kBottomless;
  for (const Place& place : places_) {
    if (!place.empty() && (place.touched || !touched)) {
      const double near = atMost(place.distance_m, kNearM);
      const double risen = atMost(kSteeper * place.rise * near, kMostRise * place.depth_m);
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

}  // namespace glider::hooks
