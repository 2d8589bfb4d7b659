// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Windows over a leg as running sums: of the present leg and of the one before. Every result is
// settled, which also rounds values that a 486 holds in a wider register, so the bits are the same
// on all boards.

#include "runtime/numbers/leg_window.h"

namespace glider::runtime {
namespace {

/// Of the readings of a leg.
struct Sums {
  double count;
  double first;
  double sum;  ///< of the readings less the first, to lose no digits
  double lowest;
  double at_lowest;
  double highest;
  double at_highest;

  void clear() { count = 0.0; }

  void take(double value, double at) {
    if (count == 0.0) {
      first = lowest = highest = value;
      at_lowest = at_highest = at;
      sum = 0.0;
    }
    count += 1.0;
    sum = gliderSettle(sum + gliderSettle(value - first));
    if (value < lowest) {
      lowest = value;
      at_lowest = at;
    }
    if (value > highest) {
      highest = value;
      at_highest = at;
    }
  }

  void finish() {}

  double worth(GliderLegKind kind) const {
    if (count == 0.0) {
      return unknown();
    }
    switch (kind) {
      case kGliderLegMean:
        return within(gliderSettle(first + gliderSettle(sum / count)));
      case kGliderLegLowest:
        return lowest;
      case kGliderLegHighest:
        return highest;
      case kGliderLegSpread:
        return gliderSettle(highest - lowest);
      case kGliderLegAtLowest:
        return at_lowest;
      case kGliderLegAtHighest:
      case kGliderLegSteepest:
      case kGliderLegAtSteepest:
      case kGliderLegNumber:
        break;
    }
    return at_highest;
  }

 private:
  /// A mean lies between the lowest and the highest; its rounding may not.
  double within(double mean) const {
    return mean < lowest ? lowest : highest < mean ? highest : mean;
  }
};
static_assert(sizeof(LegMemory<Sums>) == GLIDER_LEG_MEMORY * sizeof(double));

}  // namespace
}  // namespace glider::runtime

extern "C" void gliderLegStart(double* memory, double time) {
  glider::runtime::LegWindow<glider::runtime::Sums>::start(memory, time);
}

extern "C" void gliderLegAdvance(double* memory, const GliderLegShape* shape, double time,
                                 double phase, double value, double at, uint32_t fresh) {
  glider::runtime::LegWindow<glider::runtime::Sums>(memory, *shape)
      .advance(time, phase, value, at, fresh != 0);
}
