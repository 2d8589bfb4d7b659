// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The vehicle commands of behaviour.h: each sets the command in force, or is refused and counted.
// Values that a command does not use are 0, so that equal commands give equal contexts.

#include "runtime/abi/behaviour.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

/// False, and counted, if a value is unknown (or infinite, which only foreign code can compute).
bool known(GliderContext& context, double a, double b) {
  if (isFinite(a) && isFinite(b)) {
    return true;
  }
  ++context.refused_commands;
  return false;
}

void setVertical(GliderContext& context, GliderVertical vertical, double depth, double pitch) {
  context.vertical = vertical;
  context.depth = depth;
  context.pitch = pitch;
}

/// A dive or climb at a pitch or speed. Not inlined: it is shared by both, and a board has little
/// room.
__attribute__((noinline)) void setSlope(GliderContext& context, GliderVertical vertical,
                                        double depth, double pitch) {
  if (known(context, depth, pitch)) {
    setVertical(context, vertical, depth, pitch);
  }
}

void setLateral(GliderContext& context, GliderLateral lateral, double heading, double latitude,
                double longitude) {
  context.lateral = lateral;
  context.heading = heading;
  context.magnetic = heading;
  context.latitude = latitude;
  context.longitude = longitude;
}

/// The same direction in [0, 2 pi).
double wrapped(double heading) {
  const double rest = restOf(magnitude(heading), kTwoPi);
  const double positive = heading < 0.0 && rest > 0.0 ? kTwoPi - rest : rest;
  return positive < kTwoPi ? positive : 0.0;
}

/// Pump (cc) and pitch battery (inches), of which one is commanded: the other stays if it is in
/// force, and is in the middle otherwise.
__attribute__((noinline)) void setActuator(GliderContext& context,
                                           double GliderContext::* commanded, double value) {
  if (!known(context, value, 0.0)) {
    return;
  }
  if (context.vertical != kGliderActuators) {
    setVertical(context, kGliderActuators, 0.0, 0.0);
  }
  context.*commanded = value;
}

constexpr double kCcPerCubicMetre = 1e6;
constexpr double kMetresPerInch = 0.0254;

}  // namespace
}  // namespace glider::runtime

using glider::runtime::known;
using glider::runtime::magnitude;
using glider::runtime::negated;
using glider::runtime::setActuator;
using glider::runtime::setLateral;
using glider::runtime::setSlope;
using glider::runtime::setVertical;

extern "C" void gliderDescend(GliderContext* context, double depth, double pitch) {
  setSlope(*context, kGliderDescend, depth, negated(magnitude(pitch)));
}

extern "C" void gliderAscend(GliderContext* context, double depth, double pitch) {
  setSlope(*context, kGliderAscend, depth, magnitude(pitch));
}

extern "C" void gliderDescendAt(GliderContext* context, double depth, double speed) {
  setSlope(*context, kGliderDescend, depth, magnitude(speed));
}

extern "C" void gliderAscendAt(GliderContext* context, double depth, double speed) {
  setSlope(*context, kGliderAscend, depth, magnitude(speed));
}

extern "C" void gliderHover(GliderContext* context, double depth) {
  if (known(*context, depth, 0.0)) {
    setVertical(*context, kGliderHover, depth, 0.0);
  }
}

extern "C" void gliderSurface(GliderContext* context) {
  setVertical(*context, kGliderSurface, 0.0, 0.0);
}

extern "C" void gliderDriftFree(GliderContext* context) {
  setLateral(*context, kGliderDrift, 0.0, 0.0, 0.0);
}

extern "C" void gliderSteer(GliderContext* context, double heading) {
  if (known(*context, heading, 0.0)) {
    setLateral(*context, kGliderHeading, glider::runtime::wrapped(heading), 0.0, 0.0);
  }
}

extern "C" void gliderSteerTo(GliderContext* context, double latitude, double longitude) {
  if (known(*context, latitude, longitude)) {
    setLateral(*context, kGliderWaypoint, 0.0, latitude, longitude);
  }
}

extern "C" void gliderFin(GliderContext* context, double angle) {
  if (known(*context, angle, 0.0)) {
    setLateral(*context, kGliderFin, angle, 0.0, 0.0);
  }
}

extern "C" void gliderPump(GliderContext* context, double volume) {
  setActuator(*context, &GliderContext::depth, volume * glider::runtime::kCcPerCubicMetre);
}

extern "C" void gliderBattery(GliderContext* context, double position) {
  setActuator(*context, &GliderContext::pitch, position / glider::runtime::kMetresPerInch);
}
