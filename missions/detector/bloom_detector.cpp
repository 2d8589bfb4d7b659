// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Finds a bloom as a change of the mean, by a cumulative sum (Page 1954): what chlorophyll has
// above its slow background adds up, what it has below takes away. One high reading does nothing; a
// few do.

#include "bloom_detector.h"

namespace {

constexpr double kMemory_s = 1800;  // of the background
constexpr double kSlack = 0.5;      // above the background, and no bloom yet
constexpr double kMostScore = 100;  // so that it comes down again

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

// Both states of the mission ask, and one of them may in a tick in which the other has: time tells.
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

// A sensor of this computer: what the detector takes for the background.
double sensor_background(double) {
  return detector.begun ? detector.background : __builtin_nan("");
}
