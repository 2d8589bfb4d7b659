// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/instruction.h"

#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

hooks::HookVertical verticalOf(uint32_t vertical) {
  switch (static_cast<GliderVertical>(vertical)) {
    case kGliderDescend:
      return hooks::HookVertical::Descend;
    case kGliderAscend:
      return hooks::HookVertical::Ascend;
    case kGliderHover:
      return hooks::HookVertical::Hover;
    case kGliderSurface:
      return hooks::HookVertical::Surface;
    case kGliderActuators:
      return hooks::HookVertical::Actuators;
    case kGliderNoVertical:
      break;
  }
  return hooks::HookVertical::None;
}

hooks::HookLateral lateralOf(uint32_t lateral) {
  switch (static_cast<GliderLateral>(lateral)) {
    case kGliderHeading:
      return hooks::HookLateral::Heading;
    case kGliderWaypoint:
      return hooks::HookLateral::Waypoint;
    case kGliderFin:
      return hooks::HookLateral::Fin;
    case kGliderDrift:
      break;
  }
  return hooks::HookLateral::Drift;
}

}  // namespace

double degreesMinutesOf(double degrees) {
  const double size = magnitude(degrees);
  const double part = restOf(size, 1.0);
  const double minutes = part * 60.0;
  const double whole = size - part;
  double value = whole * 100.0 + minutes;
  if (value - whole * 100.0 >= 60.0) {  // 59.9999… was rounded up to 60 minutes
    value = (whole + 1.0) * 100.0;
  }
  return doubleOf(bitsOf(value) | (bitsOf(degrees) & kSignBit));
}

hooks::Instruction instructionFor(const GliderContext& context) {
  hooks::Instruction instruction;
  instruction.vertical = verticalOf(context.vertical);
  instruction.lateral = lateralOf(context.lateral);
  instruction.depth_m = context.depth;
  instruction.pitch_rad = context.pitch;
  instruction.heading_rad = context.magnetic;
  instruction.latitude_ddmm = degreesMinutesOf(context.latitude);
  instruction.longitude_ddmm = degreesMinutesOf(context.longitude);
  hooks::Instruction rounded;
  hookInSteps(&instruction, &rounded);
  // Just under a full turn, rounded up past the sensor's range.
  if (rounded.lateral == hooks::HookLateral::Heading && rounded.heading_rad >= kTwoPi) {
    rounded.heading_rad = 0.0;
  }
  return rounded;
}

bool sameCommand(const hooks::Instruction& a, const hooks::Instruction& b) {
  return a.vertical == b.vertical && a.lateral == b.lateral && a.depth_m == b.depth_m &&
         a.pitch_rad == b.pitch_rad && a.heading_rad == b.heading_rad &&
         a.latitude_ddmm == b.latitude_ddmm && a.longitude_ddmm == b.longitude_ddmm;
}

}  // namespace glider::runtime
