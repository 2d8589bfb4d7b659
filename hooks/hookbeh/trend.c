// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/trend.h"

#include "hooks/protocol/numbers.h"

/// Fewer readings may lie on a line by chance.
enum { kFewestOnLine = 6 };
/// m; less is not a motion. In swell of a metre, 20 s of a dive at 26 degrees.
static const double kTrendMovesM = 3;
/// m; swell of a metre, with noise, leaves no more than this.
static const double kFarthestM = 1.5;
/// The line must rise this many times as far as any reading is off it: the more readings, the
/// less.
static const double kClearOfFew = 4;
static const double kClearOfSeven = 3.5;
static const double kClearOfNine = 3;
/// And this many times as far as readings usually are off.
static const double kClearOfRough = 2;
/// m; what swell adds to the fastest motion.
static const double kTrendSwellM = 1;

/// The line depth = offset + slope · time, times and depths from those of the newest reading.
typedef struct Line {
  double offset_m;
  double slope_mps;
} Line;

void hookTrendInit(HookTrend* trend) {
  for (int i = 0; i < kHookTrendReadings; ++i) {
    trend->readings[i].at_s = trend->readings[i].depth_m = 0;
  }
  trend->next = trend->count = 0;
}

void hookTrendClear(HookTrend* trend) {
  trend->count = 0;
}

/// `back` 0: the newest.
static const HookTrendReading* readingBack(const HookTrend* trend, int back) {
  return &trend->readings[(trend->next + kHookTrendReadings - 1 - back) % kHookTrendReadings];
}

void hookTrendAdd(HookTrend* trend, double depth_m, double gap_s) {
  const double at_s = trend->count > 0 ? readingBack(trend, 0)->at_s + gap_s : 0;
  trend->readings[trend->next].at_s = at_s;
  trend->readings[trend->next].depth_m = depth_m;
  trend->next = (uint8_t)((trend->next + 1) % kHookTrendReadings);
  trend->count =
      (uint8_t)(trend->count < kHookTrendReadings ? trend->count + 1 : kHookTrendReadings);
}

static Line lineThrough(const HookTrend* trend, int count) {
  const HookTrendReading* newest = readingBack(trend, 0);
  double t = 0, d = 0, tt = 0, td = 0;
  for (int i = 0; i < count; ++i) {
    const double time = readingBack(trend, i)->at_s - newest->at_s;
    const double depth = readingBack(trend, i)->depth_m - newest->depth_m;
    t += time;
    d += depth;
    tt += time * time;
    td += time * depth;
  }
  const double slope = (td - t * d / count) / (tt - t * t / count);
  const Line line = {(d - slope * t) / count, slope};
  return line;
}

static double farthestFrom(const HookTrend* trend, const Line* line, int count) {
  const HookTrendReading* newest = readingBack(trend, 0);
  double farthest = 0;
  for (int i = 0; i < count; ++i) {
    const double on_line = newest->depth_m + line->offset_m +
                           line->slope_mps * (readingBack(trend, i)->at_s - newest->at_s);
    farthest = hookAtLeast(hookMagnitude(readingBack(trend, i)->depth_m - on_line), farthest);
  }
  return farthest;
}

static double clearOf(int count) {
  return count >= 9 ? kClearOfNine : count >= 7 ? kClearOfSeven : kClearOfFew;
}

double hookTrendMoved(const HookTrend* trend, double roughness_m, double fastest_mps) {
  for (int count = kFewestOnLine; count <= trend->count; ++count) {
    const Line line = lineThrough(trend, count);
    const double secs = readingBack(trend, 0)->at_s - readingBack(trend, count - 1)->at_s;
    const double moved = line.slope_mps * secs;
    const double distance = hookMagnitude(moved);
    const double off = farthestFrom(trend, &line, count);
    if (distance >= kTrendMovesM && distance <= fastest_mps * secs + kTrendSwellM &&
        off <= kFarthestM && distance >= clearOf(count) * off &&
        distance >= kClearOfRough * roughness_m) {
      return moved;
    }
  }
  return 0;
}
