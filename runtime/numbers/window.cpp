// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Windows as a ring of bins: a bin keeps its newest reading, so that noise of the abscissa,
// repeated and late readings and hovering cost no memory. Every result is settled, which also
// rounds values that a 486 holds in a wider register, so the bits are the same on all boards.

#include "runtime/abi/window.h"

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

/// memory[0..4]
struct Header {
  double value;
  double since;    ///< mission time of the start, s
  double nearest;  ///< least and greatest `along` seen since; unknown before the first
  double farthest;
  double newest;  ///< bin of the newest reading; unknown before the first
};
struct Slot {
  double bin;  ///< number of the bin; unknown: empty
  double time;
  double along;
  double value;
};
static_assert(sizeof(Header) == GLIDER_WINDOW_HEADER * sizeof(double));
static_assert(sizeof(Slot) == GLIDER_WINDOW_SLOT * sizeof(double));

/// Beyond this a double holds no fraction, and bins are not numbered.
constexpr double kGreatestBin = 4503599627370496.0;

bool isKnown(double value) {
  return value == value;
}

double difference(double a, double b) {
  return gliderSettle(a - b);
}
double sum(double a, double b) {
  return gliderSettle(a + b);
}
double product(double a, double b) {
  return gliderSettle(a * b);
}
double quotient(double a, double b) {
  return gliderSettle(a / b);
}

/// The number of the bin that holds `along`; unknown if it is too far away.
double binOf(double along, double width) {
  const double exact = quotient(along, width);
  if (!(exact > -kGreatestBin && exact < kGreatestBin)) {
    return unknown();
  }
  const auto towards_zero = static_cast<double>(static_cast<int64_t>(exact));
  return towards_zero > exact ? towards_zero - 1.0 : towards_zero;
}

class Window {
 public:
  Window(double* memory, const GliderWindowShape& shape)
      : header_(*reinterpret_cast<Header*>(memory)),
        slots_(reinterpret_cast<Slot*>(memory + GLIDER_WINDOW_HEADER)),
        shape_(shape) {}

  void start(double time) {
    header_ = {unknown(), time, unknown(), unknown(), unknown()};
    for (uint32_t i = 0; i < shape_.bins; ++i) {
      slots_[i].bin = unknown();
    }
  }

  void take(double time, double along, double value) {
    const double bin = binOf(along, shape_.bin);
    if (!isKnown(bin)) {
      return;
    }
    forgetBetween(header_.newest, bin);
    header_.newest = bin;
    slots_[placeOf(bin)] = {bin, time, along, value};
    if (!(header_.nearest <= along)) {
      header_.nearest = along;
    }
    if (!(header_.farthest >= along)) {
      header_.farthest = along;
    }
  }

  void workOut(double time, double now) {
    if (!isKnown(now)) {
      header_.value = unknown();
      return;
    }
    forget(time, now);
    header_.value = covered(time) ? worth(now) : unknown();
  }

 private:
  /// The number of the slot for a known bin: modulo the number of slots, of which there are fewer
  /// than 2^16. In steps of 16 bits: a division of 64 is a library call, of 800 bytes on a board.
  [[nodiscard]] uint32_t placeOf(double bin) const {
    const auto number = static_cast<uint64_t>(static_cast<int64_t>(magnitude(bin)));
    const auto low = static_cast<uint32_t>(number);
    uint32_t rest = static_cast<uint32_t>(number >> 32U) % shape_.bins;
    rest = (rest << 16U | low >> 16U) % shape_.bins;
    rest = (rest << 16U | (low & 0xFFFFU)) % shape_.bins;
    return bin < 0 && rest != 0 ? shape_.bins - rest : rest;
  }

  bool covered(double time) const {
    const double seen = shape_.stretch != 0 ? difference(header_.farthest, header_.nearest)
                                            : difference(time, header_.since);
    return seen >= shape_.length;
  }

  bool within(const Slot& slot, double time, double now) const {
    const double off = difference(now, slot.along);
    if (shape_.stretch == 0) {
      return off <= shape_.length;
    }
    return magnitude(off) <= shape_.length &&
           difference(time, slot.time) <= GLIDER_STRETCH_MEMORY_S;
  }

  /// Clears the bins between two consecutive readings: that stretch was just passed, so earlier
  /// readings in it are outdated.
  void forgetBetween(double a, double b) {
    for (uint32_t i = 0; i < shape_.bins; ++i) {
      const double bin = slots_[i].bin;
      if ((a < bin && bin < b) || (b < bin && bin < a)) {
        slots_[i].bin = unknown();
      }
    }
  }

  /// Clears readings outside the window: a reading that has left the window does not come back.
  void forget(double time, double now) {
    for (uint32_t i = 0; i < shape_.bins; ++i) {
      if (isKnown(slots_[i].bin) && !within(slots_[i], time, now)) {
        slots_[i].bin = unknown();
      }
    }
  }

  /// Sums over the readings within the window, in the order of their bins.
  struct Sums {
    double count = 0;
    double value = 0;  ///< less that of the first reading, to lose no digits
    double along = 0;  ///< less `now`
    double along_along = 0;
    double along_value = 0;
    double first = 0;
    double lowest = 0;
    double highest = 0;
  };

  static void add(Sums& sums, const Slot& slot, double now) {
    if (sums.count == 0) {
      sums.first = sums.lowest = sums.highest = slot.value;
    }
    const double along = difference(slot.along, now);
    const double value = difference(slot.value, sums.first);
    sums.count += 1;
    sums.value = sum(sums.value, value);
    sums.along = sum(sums.along, along);
    sums.along_along = sum(sums.along_along, product(along, along));
    sums.along_value = sum(sums.along_value, product(along, value));
    sums.lowest = slot.value < sums.lowest ? slot.value : sums.lowest;
    sums.highest = slot.value > sums.highest ? slot.value : sums.highest;
  }

  static double slope(const Sums& s) {
    const double below = difference(product(s.count, s.along_along), product(s.along, s.along));
    if (!(below > 0)) {
      return unknown();
    }
    return quotient(difference(product(s.count, s.along_value), product(s.along, s.value)), below);
  }

  double worth(double now) {
    Sums sums;
    const double last = binOf(sum(now, shape_.stretch != 0 ? shape_.length : 0.0), shape_.bin);
    double bin = binOf(difference(now, shape_.length), shape_.bin);
    if (!(bin <= last)) {
      return unknown();
    }
    uint32_t place = placeOf(bin);
    for (uint32_t i = 0; i < shape_.bins && bin <= last; ++i, bin += 1.0) {
      if (slots_[place].bin == bin) {
        add(sums, slots_[place], now);
      }
      place = place + 1 < shape_.bins ? place + 1 : 0;
    }
    if (sums.count == 0) {
      return unknown();
    }
    switch (static_cast<GliderWindowKind>(shape_.kind)) {
      case kGliderMean:
        return sum(sums.first, quotient(sums.value, sums.count));
      case kGliderLowest:
        return sums.lowest;
      case kGliderHighest:
        return sums.highest;
      case kGliderSpread:
        return difference(sums.highest, sums.lowest);
      case kGliderSlope:
        break;
    }
    return slope(sums);
  }

  Header& header_;
  Slot* slots_;
  const GliderWindowShape& shape_;
};

}  // namespace
}  // namespace glider::runtime

extern "C" void gliderWindowStart(double* memory, const GliderWindowShape* shape, double time) {
  glider::runtime::Window(memory, *shape).start(time);
}

extern "C" void gliderWindowAdvance(double* memory, const GliderWindowShape* shape, double time,
                                    double along, double value, uint32_t fresh) {
  glider::runtime::Window window(memory, *shape);
  if (fresh != 0 && along == along && value == value) {
    window.take(time, along, value);
  }
  window.workOut(time, along);
}
