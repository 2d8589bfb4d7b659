// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Windows over a leg as running sums: of the present leg and of the one before. Every result is
// settled, which also rounds values that a 486 holds in a wider register, so the bits are the same
// on all boards.

#include "runtime/abi/leg.h"

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/numbers.h"

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
};

/// memory[0…]
struct Memory {
  double value;
  double since;  ///< mission time of the start, s
  double phase;  ///< of the newest tick on which it was known; unknown before the first
  double time;   ///< of that tick, s
  double whole;  ///< 1: the present leg has been watched since it began
  double begun;  ///< the number of legs that have begun
  Sums present;
  Sums last;
};
static_assert(sizeof(Memory) == GLIDER_LEG_MEMORY * sizeof(double));

class Leg {
 public:
  Leg(double* memory, const GliderLegShape& shape)
      : memory_(*reinterpret_cast<Memory*>(memory)), shape_(shape) {}

  void advance(double time, double phase) {
    if (startsAt(time)) {
      memory_.phase = phase;
      return;
    }
    const bool watched = gliderSettle(time - memory_.time) <= GLIDER_LEG_GAP_S;
    if (!watched) {
      forget();
    }
    if (isLeg(phase) && phase != memory_.phase) {
      begin(watched);
    }
    memory_.phase = phase;
    memory_.time = time;
  }

  void take(double value, double at) {
    Sums& s = memory_.present;
    if (s.count == 0.0) {
      s.first = s.lowest = s.highest = value;
      s.at_lowest = s.at_highest = at;
      s.sum = 0.0;
    }
    s.count += 1.0;
    s.sum = gliderSettle(s.sum + gliderSettle(value - s.first));
    if (value < s.lowest) {
      s.lowest = value;
      s.at_lowest = at;
    }
    if (value > s.highest) {
      s.highest = value;
      s.at_highest = at;
    }
  }

  bool startsAt(double time) const { return time == memory_.since; }

  bool isLeg(double phase) const { return phase == shape_.dive || phase == shape_.climb; }

  double worth() const {
    const Sums& s = shape_.last != 0 ? memory_.last : memory_.present;
    if (shape_.kind == kGliderLegNumber) {
      return memory_.begun;
    }
    if (s.count == 0.0) {
      return unknown();
    }
    switch (static_cast<GliderLegKind>(shape_.kind)) {
      case kGliderLegMean:
        return within(s, gliderSettle(s.first + gliderSettle(s.sum / s.count)));
      case kGliderLegLowest:
        return s.lowest;
      case kGliderLegHighest:
        return s.highest;
      case kGliderLegSpread:
        return gliderSettle(s.highest - s.lowest);
      case kGliderLegAtLowest:
        return s.at_lowest;
      case kGliderLegAtHighest:
      case kGliderLegNumber:
        break;
    }
    return s.at_highest;
  }

 private:
  /// Legs may have come and gone that were not watched: no leg is certainly the one before.
  void forget() { memory_.whole = memory_.present.count = memory_.last.count = 0.0; }

  /// A leg that was under way when the state of the vehicle became known is not counted, nor whole.
  void begin(bool watched) {
    if (memory_.whole == 1.0) {
      memory_.last = memory_.present;
    } else {
      memory_.last.count = 0.0;
    }
    memory_.present.count = 0.0;
    memory_.whole = watched && isKnown(memory_.phase) ? 1.0 : 0.0;
    memory_.begun += isKnown(memory_.phase) ? 1.0 : 0.0;
  }

  /// A mean lies between the lowest and the highest; its rounding may not.
  static double within(const Sums& s, double mean) {
    return mean < s.lowest ? s.lowest : s.highest < mean ? s.highest : mean;
  }

  Memory& memory_;
  const GliderLegShape& shape_;
};

}  // namespace
}  // namespace glider::runtime

extern "C" void gliderLegStart(double* memory, double time) {
  using glider::runtime::unknown;
  *reinterpret_cast<glider::runtime::Memory*>(memory) = {unknown(), time, unknown(), time,
                                                         0.0,       0.0,  {},        {}};
}

extern "C" void gliderLegAdvance(double* memory, const GliderLegShape* shape, double time,
                                 double phase, double value, double at, uint32_t fresh) {
  glider::runtime::Leg leg(memory, *shape);
  if (phase != phase) {
    memory[0] = glider::runtime::unknown();
    return;
  }
  const bool starts = leg.startsAt(time);
  leg.advance(time, phase);
  if (!starts && fresh != 0 && leg.isLeg(phase) && value == value && at == at) {
    leg.take(value, at);
  }
  memory[0] = starts ? glider::runtime::unknown() : leg.worth();
}
