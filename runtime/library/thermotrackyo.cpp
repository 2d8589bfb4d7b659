// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `thermotrackyo` of missions/library/standard.mission, step by step and bit by bit: that file says
// what it does and why. tests/flights/library_test.cpp compares the two.

#include "runtime/abi/window.h"
#include "runtime/core/assert.h"
#include "runtime/library/library.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

constexpr double kEverywhere = 10e3;   ///< m, reach while the layer is searched for
constexpr double kReach = 0.4;         ///< of ddepth
constexpr uint32_t kMostMissed = 2;    ///< legs
constexpr double kOldestPartner = 6;   ///< s, of two readings that belong together
constexpr double kBinsOfStretch = 32;  ///< of a window over a stretch, to each side

/// The window functions of temperature over ddepth of depth, one for each function of the language.
struct Windows {
  static constexpr uint32_t kBins = 66;
  static constexpr uint32_t kDoubles = GLIDER_WINDOW_HEADER + GLIDER_WINDOW_SLOT * kBins;

  double lowest[kDoubles];
  double spread[kDoubles];
  double slope[kDoubles];
};

/// `became(g)` of a `g` that the owner of this object evaluates.
struct Became {
  uint32_t was_true;
  uint32_t is;

  void start(bool now) {
    was_true = now ? 1 : 0;
    is = 0;
  }
  void advance(bool now) {
    is = now && was_true == 0 ? 1 : 0;
    was_true = now ? 1 : 0;
  }
};

struct Arguments {
  double top, bottom, dive, climb, dtemp, ddepth;
};

double depthOf(const GliderContext* context) {
  return gliderRead(context, gliderSensorOf(context, kGliderRoleDepth));
}
double temperatureOf(const GliderContext* context) {
  return gliderRead(context, gliderSensorOf(context, kGliderRoleWaterTemperature));
}

/// The lesser of two; unknown if either is.
double least(double a, double b) {
  return a != a ? a : b < a || b != b ? b : a;
}
double greatest(double a, double b) {
  return a != a ? a : a < b || b != b ? b : a;
}
double clamped(double x, double low, double high) {
  return low != low ? low : high != high ? high : x < low ? low : high < x ? high : x;
}

/// The variables that the profile has in the language, and its temporals.
struct Thermotrackyo {
  double layer;
  double reach;
  double middle;
  double slant;
  double length;  ///< of the windows: ddepth when the state was entered
  uint32_t down;
  uint32_t missed;
  Became below;
  Became above;
  Windows windows;

  [[nodiscard]] bool knowsSides() const {
    return (below.was_true | below.is | above.was_true | above.is) <= 1;
  }
  void enter(const GliderContext* context, const Arguments& a);
  void resume(const GliderContext* context);
  void advance(const GliderContext* context);
  void depart(GliderContext* context, const Arguments& a);
  void tick(GliderContext* context, const Arguments& a);

 private:
  [[nodiscard]] double beyondMiddle(const GliderContext* context) const;
  void window(const GliderContext* context, double* memory, GliderWindowKind kind, bool start);
  void advanceWindows(const GliderContext* context, bool start);
  [[nodiscard]] double lower(const Arguments& a) const { return least(layer + reach, a.bottom); }
  [[nodiscard]] double upper(const Arguments& a) const { return greatest(layer - reach, a.top); }
  void fly(GliderContext* context, const Arguments& a) const;
  void measure(const Arguments& a);
  void pass(const GliderContext* context, double depth, const Arguments& a);
  void turn();
};
static_assert(sizeof(Thermotrackyo) <= GLIDER_BEHAVIOUR_MEMORY_BYTES);

/// (temp - middle) / slant, m.
double Thermotrackyo::beyondMiddle(const GliderContext* context) const {
  return gliderSettle((temperatureOf(context) - middle) / slant);
}

void Thermotrackyo::window(const GliderContext* context, double* memory, GliderWindowKind kind,
                           bool start) {
  const double depth_age = gliderAge(context, gliderSensorOf(context, kGliderRoleDepth));
  const double temperature_age =
      gliderAge(context, gliderSensorOf(context, kGliderRoleWaterTemperature));
  const bool fresh = depth_age <= kOldestPartner && temperature_age <= kOldestPartner &&
                     (depth_age == 0.0 || temperature_age == 0.0);
  const GliderWindowShape shape{length, length / kBinsOfStretch, Windows::kBins, kind, 1, 0};
  const double time = gliderMissionTime(context);
  if (start) {
    gliderWindowStart(memory, &shape, time);
  }
  gliderWindowAdvance(memory, &shape, time, depthOf(context), temperatureOf(context),
                      fresh ? 1 : 0);
}

void Thermotrackyo::advanceWindows(const GliderContext* context, bool start) {
  window(context, windows.lowest, kGliderLowest, start);
  window(context, windows.spread, kGliderSpread, start);
  window(context, windows.slope, kGliderSlope, start);
}

void Thermotrackyo::enter(const GliderContext* context, const Arguments& a) {
  layer = 0;
  reach = kEverywhere;
  middle = 0;
  slant = 0;
  length = a.ddepth;
  down = 1;
  missed = 0;
  below.start(beyondMiddle(context) > 0.0);
  above.start(beyondMiddle(context) < 0.0);
  advanceWindows(context, true);
}

void Thermotrackyo::resume(const GliderContext* context) {
  below.start(beyondMiddle(context) > 0.0);
  above.start(beyondMiddle(context) < 0.0);
  advanceWindows(context, false);
}

void Thermotrackyo::advance(const GliderContext* context) {
  below.advance(beyondMiddle(context) > 0.0);
  above.advance(beyondMiddle(context) < 0.0);
  advanceWindows(context, false);
}

void Thermotrackyo::fly(GliderContext* context, const Arguments& a) const {
  if (down != 0) {
    gliderDescend(context, lower(a), a.dive);
  } else {
    gliderAscend(context, upper(a), a.climb);
  }
}

/// The profile's `entry`.
void Thermotrackyo::depart(GliderContext* context, const Arguments& a) {
  const double depth = depthOf(context);
  const double bottom = lower(a);
  if (depth != depth || depth >= bottom) {
    down = 0;
  } else if (depth < bottom) {
    down = 1;
  }
  fly(context, a);
}

void Thermotrackyo::measure(const Arguments& a) {
  if (windows.spread[0] >= a.dtemp) {
    middle = windows.lowest[0] + windows.spread[0] / 2;
    if (reach > a.ddepth && windows.slope[0] == windows.slope[0]) {
      slant = windows.slope[0];
    }
  }
}

void Thermotrackyo::pass(const GliderContext* context, double depth, const Arguments& a) {
  const double most = least(reach, a.ddepth) / 2;
  const double behind = clamped(beyondMiddle(context), -most, most);
  const double there = clamped(gliderSettle(depth - behind), a.top, a.bottom);
  const double near = gliderSettle(kReach * a.ddepth);
  layer = there == there ? there : layer;
  reach = near == near ? near : reach;
  missed = 0;
}

void Thermotrackyo::turn() {
  down = down != 0 ? 0 : 1;
  if (++missed > kMostMissed) {
    reach = kEverywhere;
  }
}

/// The profile's cases.
void Thermotrackyo::tick(GliderContext* context, const Arguments& a) {
  const double depth = depthOf(context);
  if (depth != depth) {
    down = 0;
    fly(context, a);
    return;
  }
  measure(a);
  if ((down != 0 ? below.is : above.is) != 0) {
    pass(context, depth, a);
  }
  if (down != 0 ? depth >= lower(a) : depth <= upper(a)) {
    turn();
  }
  fly(context, a);
}

}  // namespace
}  // namespace glider::runtime

extern "C" void gliderProfileThermotrackyo(GliderContext* context, GliderBehaviourMemory* memory,
                                           uint32_t phase, double top, double bottom, double dive,
                                           double climb, double dtemp, double ddepth) {
  auto& own = *reinterpret_cast<glider::runtime::Thermotrackyo*>(memory->bytes);
  if (phase != kGliderEnter && (!GLIDER_ASSERT(*context, own.down <= 1, TrackDirection) ||
                                !GLIDER_ASSERT(*context, own.knowsSides(), TrackSide))) {
    return;
  }
  const glider::runtime::Arguments arguments{top, bottom, dive, climb, dtemp, ddepth};
  if (phase == kGliderTick) {
    own.advance(context);
    own.tick(context, arguments);
    return;
  }
  if (phase == kGliderEnter) {
    own.enter(context, arguments);
  } else {
    own.resume(context);
  }
  own.depart(context, arguments);
}
