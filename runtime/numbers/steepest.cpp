// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The steepest slope over a leg, from layer to layer: the means of layers are less noisy than
// readings, and readings at the same depth have no slope.

#include "runtime/numbers/leg_window.h"

namespace glider::runtime {
namespace {

/// Sums of the readings of a layer less the first, to lose no digits.
struct Layer {
  double first;
  double sum;

  void begin(double value) {
    first = value;
    sum = 0.0;
  }
  void take(double value) { sum = gliderSettle(sum + gliderSettle(value - first)); }
  double mean(double count) const { return gliderSettle(first + gliderSettle(sum / count)); }
};

/// The layers of a leg.
struct Layers {
  double count;  ///< of the readings in the layer under way
  Layer value;
  Layer at;
  double value_before;  ///< the means of the complete layer before; unknown: there is none
  double at_before;
  double steepest;  ///< unknown: none yet
  double at_steepest;

  void clear() {
    count = 0.0;
    value_before = at_before = steepest = at_steepest = unknown();
  }

  void take(double new_value, double new_at) {
    if (count != 0.0 && magnitude(gliderSettle(new_at - at.first)) >= GLIDER_LEG_LAYER) {
      finish();
    }
    if (count == 0.0) {
      value.begin(new_value);
      at.begin(new_at);
    }
    count += 1.0;
    value.take(new_value);
    at.take(new_at);
  }

  /// The layer under way is complete.
  void finish() {
    if (count == 0.0) {
      return;
    }
    const double value_mean = value.mean(count);
    const double at_mean = at.mean(count);
    compare(gliderSettle(value_mean - value_before), gliderSettle(at_mean - at_before));
    value_before = value_mean;
    at_before = at_mean;
    count = 0.0;
  }

  double worth(GliderLegKind kind) const {
    return kind == kGliderLegSteepest ? steepest : at_steepest;
  }

 private:
  /// Of the means of two layers; unknown if there is only one.
  void compare(double change, double rise) {
    if (!(magnitude(rise) >= GLIDER_LEG_LAYER / 2)) {
      return;
    }
    const double slope = gliderSettle(change / rise);
    if (isKnown(slope) && !(magnitude(slope) <= magnitude(steepest))) {
      steepest = slope;
      at_steepest = gliderSettle(at_before + gliderSettle(rise / 2));
    }
  }
};
static_assert(sizeof(LegMemory<Layers>) == GLIDER_STEEPEST_MEMORY * sizeof(double));

}  // namespace
}  // namespace glider::runtime

extern "C" void gliderSteepestStart(double* memory, double time) {
  glider::runtime::LegWindow<glider::runtime::Layers>::start(memory, time);
}

extern "C" void gliderSteepestAdvance(double* memory, const GliderLegShape* shape, double time,
                                      double phase, double value, double at, uint32_t fresh) {
  glider::runtime::LegWindow<glider::runtime::Layers>(memory, *shape)
      .advance(time, phase, value, at, fresh != 0);
}
