// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Detects a bloom as a change of the mean, by a cumulative sum (Page 1954): chlorophyll above its
// slow background adds to the sum, and chlorophyll below it subtracts. A single high reading has no
// effect; a few have.

#include "bloom_detector.h"

namespace {

constexpr double kMemory_s = 1800;  // of the background
constexpr double kSlack = 0.5;      // above the background without being a bloom
constexpr double kMostScore = 100;  // a limit, so that the score can fall again

struct Detector {
  bool begun = false;
  double updated_s = 0;
  double background = 0;
  double score = 0;
};
Detector detector;

double between(double lowest, double x, double highest) {
  return x < lowest ? lowest : x > highest ? highest : x;
}

}  // namespace

// Both states of the mission call this, possibly in the same tick; the time shows whether the tick
// was already counted.
double function_bloom_score(double chlorophyll, double at_s) {
  const bool unknown = chlorophyll != chlorophyll || at_s != at_s;
  if (unknown || (detector.begun && at_s <= detector.updated_s)) {
    return detector.score;
  }
  if (!detector.begun) {
    detector = {true, at_s, chlorophyll, 0};
  }
  const double above = chlorophyll - detector.background;
  const double share = between(0, (at_s - detector.updated_s) / kMemory_s, 1);
  detector.score = between(0, detector.score + above - kSlack, kMostScore);
  detector.background += share * between(-kSlack, above, kSlack);
  detector.updated_s = at_s;
  return detector.score;
}

// A sensor of this computer: the background as estimated by the detector.
double sensor_background(double) {
  return detector.begun ? detector.background : __builtin_nan("");
}
