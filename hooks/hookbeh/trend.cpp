// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/trend.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// Fewer readings may lie on a line by chance.
constexpr uint8_t kLeast = 6;
/// m; less is not a motion. In swell of a metre, 20 s of a dive at 26 degrees.
constexpr double kTrendMovesM = 3;
/// m; swell of a metre, with noise, leaves no more than this.
constexpr double kFarthestM = 1.5;
/// The line must rise this many times as far as any reading is off it: the more readings, the
/// less.
constexpr double kClearOfFew = 4;
constexpr double kClearOfSeven = 3.5;
constexpr double kClearOfNine = 3;
/// And this many times as far as readings usually are off.
constexpr double kClearOfRough = 2;
/// m; what swell adds to the fastest motion.
constexpr double kTrendSwellM = 1;

double clearOf(uint8_t count) {
  return count >= 9 ? kClearOfNine : count >= 7 ? kClearOfSeven : kClearOfFew;
}

}  // namespace

void Trend::add(double depth_m, double gap_s) {
  const double at_s = count_ > 0 ? reading(0).at_s + gap_s : 0;
  readings_[next_] = {at_s, depth_m};
  next_ = static_cast<uint8_t>((next_ + 1) % kMost);
  count_ = count_ < kMost ? static_cast<uint8_t>(count_ + 1) : kMost;
}

Trend::Line Trend::through(uint8_t count) const {
  const Reading& newest = reading(0);
  double t = 0, d = 0, tt = 0, td = 0;
  for (uint8_t i = 0; i < count; ++i) {
    const double time = reading(i).at_s - newest.at_s;
    const double depth = reading(i).depth_m - newest.depth_m;
    t += time;
    d += depth;
    tt += time * time;
    td += time * depth;
  }
  const double slope = (td - t * d / count) / (tt - t * t / count);
  return {(d - slope * t) / count, slope};
}

double Trend::farthestFrom(const Line& line, uint8_t count) const {
  const Reading& newest = reading(0);
  double farthest = 0;
  for (uint8_t i = 0; i < count; ++i) {
    const double on_line =
        newest.depth_m + line.offset_m + line.slope_mps * (reading(i).at_s - newest.at_s);
    farthest = atLeast(magnitude(reading(i).depth_m - on_line), farthest);
  }
  return farthest;
}

double Trend::moved(double roughness_m, double fastest_mps) const {
  for (uint8_t count = kLeast; count <= count_; ++count) {
    const Line line = through(count);
    const double secs = reading(0).at_s - reading(static_cast<uint8_t>(count - 1)).at_s;
    const double moved = line.slope_mps * secs;
    const double far = magnitude(moved);
    const double off = farthestFrom(line, count);
    if (far >= kTrendMovesM && far <= fastest_mps * secs + kTrendSwellM && off <= kFarthestM &&
        far >= clearOf(count) * off && far >= kClearOfRough * roughness_m) {
      return moved;
    }
  }
  return 0;
}

}  // namespace glider::hooks
