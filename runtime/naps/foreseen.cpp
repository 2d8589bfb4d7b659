// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the code of a mission that may sleep calls: the list of what wakes the SBC.

#include "hooks/protocol/nap.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/order.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

/// A sensor that may go unknown sooner than this (s) is not slept over.
constexpr double kSoonest_s = 8;

/// Of two conditions of a kind the one that is met first. There is one for each sensor and kind.
void add(GliderNap& nap, uint32_t sensor, HookNapKind kind, double value) {
  uint32_t i = 0;
  while (i < nap.count &&
         (nap.wakes[i].sensor != sensor || nap.wakes[i].kind != static_cast<uint32_t>(kind))) {
    ++i;
  }
  if (i == GLIDER_MOST_WAKES) {
    nap.awake = 1;
    return;
  }
  const bool is_new = i == nap.count;
  const bool is_earlier = is_new || (kind == HookNapKind::AtMost ? value > nap.wakes[i].value
                                                                 : value < nap.wakes[i].value);
  if (is_earlier) {
    nap.wakes[i] = {value, sensor, static_cast<uint32_t>(kind)};
  }
  nap.count += is_new ? 1 : 0;
}

double ofOrder(int64_t order) {
  return doubleOf(static_cast<uint64_t>(order < 0 ? order ^ INT64_MAX : order));
}

/// The number next to `value`, which is finite, on one side: of 0 and -0 the same.
double nextTo(double value, bool above) {
  const int64_t step = above ? 1 : -1;
  const int64_t order = gliderOrder(value) + step;
  return ofOrder(ofOrder(order) == value ? order + step : order);
}

/// Wakes when a value on that side of `value`, or near it, is reported.
void addBeyond(GliderNap& nap, const GliderSensorInfo& sensor, bool above, double value) {
  add(nap, sensor.id, above ? HookNapKind::AtLeast : HookNapKind::AtMost, value);
}

/// The same, but not at `value` itself; without an end there is nothing past it.
void addPast(GliderNap& nap, const GliderSensorInfo& sensor, bool above, double value) {
  if (isFinite(value)) {
    addBeyond(nap, sensor, above, nextTo(value, above));
  }
}

/// How far before `number` it is to be woken, m: the vehicle is on its way there, and would hover
/// there until the SBC is awake.
double aheadOf(const GliderContext& context, uint32_t sensor, double number, bool above) {
  const GliderNaps& naps = *context.mission->naps;
  const bool goes_there = above ? context.vertical == kGliderDescend && number <= context.depth
                                : context.vertical == kGliderAscend && number >= context.depth;
  return sensor == naps.depth && goes_there ? naps.ahead : 0;
}

/// In the vehicle's unit. The quotient is rounded: a little on the side of waking too early.
double inUnitOf(const GliderSensorInfo& sensor, double number, bool above) {
  constexpr double kRounded = 0x1p-40;
  if (sensor.to_si == 1) {
    return number;
  }
  const double quotient = number / sensor.to_si;
  const double margin = (quotient < 0 ? -quotient : quotient) * kRounded;
  return above ? quotient - margin : quotient + margin;
}

const GliderSensorInfo& infoOf(const GliderContext& context, uint32_t sensor) {
  return context.mission->sensors[sensor];
}

/// Whether the vehicle's side can compare it: it reports what the mission reads, up to a factor.
bool isCompared(const GliderSensorInfo& sensor) {
  return sensor.poll == nullptr && sensor.encoding == kGliderLinear && sensor.to_si > 0;
}

}  // namespace
}  // namespace glider::runtime

using glider::runtime::isKnown;

extern "C" void gliderNapAwake(GliderNap* nap) {
  nap->awake = 1;
}

extern "C" void gliderNapUntil(GliderNap* nap, double seconds) {
  if (seconds >= 0 && seconds < nap->seconds) {
    nap->seconds = seconds;
  }
}

extern "C" void gliderNapKnown(GliderNap* nap, const GliderContext* context, uint32_t sensor) {
  const GliderSensorInfo& info = glider::runtime::infoOf(*context, sensor);
  if (info.poll != nullptr) {
    nap->awake = 1;
  } else if (!isKnown(context->readings[sensor].value)) {
    glider::runtime::add(*nap, info.id, HookNapKind::Known, 0);
  }
}

extern "C" void gliderNapCrossed(GliderNap* nap, const GliderContext* context, uint32_t sensor,
                                 double number) {
  const GliderSensorInfo& info = glider::runtime::infoOf(*context, sensor);
  const GliderReading& reading = context->readings[sensor];
  if (!isKnown(number)) {
    return;
  }
  if (!glider::runtime::isCompared(info)) {
    nap->awake = 1;
  } else if (!isKnown(reading.value)) {
    gliderNapKnown(nap, context, sensor);
  } else if (reading.value == number) {
    glider::runtime::addPast(*nap, info, true, reading.raw);
    glider::runtime::addPast(*nap, info, false, reading.raw);
  } else {
    const bool above = reading.value < number;
    const double ahead = glider::runtime::aheadOf(*context, sensor, number, above);
    const double first = above ? number - ahead : number + ahead;
    if (above ? reading.value >= first : reading.value <= first) {
      nap->awake = 1;
    }
    glider::runtime::addBeyond(*nap, info, above, glider::runtime::inUnitOf(info, first, above));
  }
}

/// It may be reported as what it cannot be, or not at all.
extern "C" void gliderNapLost(GliderNap* nap, const GliderContext* context, uint32_t sensor) {
  const GliderSensorInfo& info = glider::runtime::infoOf(*context, sensor);
  const GliderReading& reading = context->readings[sensor];
  if (!isKnown(reading.value)) {
    return;
  }
  const double left = info.stale_after - (context->mission_time - reading.updated);
  if (info.poll != nullptr || left < glider::runtime::kSoonest_s) {
    nap->awake = 1;
    return;
  }
  glider::runtime::addPast(*nap, info, true, info.highest);
  glider::runtime::addPast(*nap, info, false, info.lowest);
  glider::runtime::add(*nap, info.id, HookNapKind::Quiet, left);
}
