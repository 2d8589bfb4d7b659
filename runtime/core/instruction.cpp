// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/instruction.h"

#include "runtime/numbers/numbers.h"

#include <stddef.h>

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
  instruction.sampling = context.sampling;
  hooks::Instruction rounded;
  hookInSteps(&instruction, &rounded);
  // Just under a full turn, rounded up past the sensor's range.
  if (rounded.lateral == hooks::HookLateral::Heading && rounded.heading_rad >= kTwoPi) {
    rounded.heading_rad = 0.0;
  }
  return rounded;
}

/// Its numbers are in whole steps, so that those of the same command have the same bits.
bool sameCommand(const hooks::Instruction& a, const hooks::Instruction& b) {
  using Numbers = hooks::Instruction;
  constexpr size_t kFirst = offsetof(Numbers, depth_m);
  constexpr size_t kEnd = offsetof(Numbers, longitude_ddmm) + sizeof(double);
  static_assert(kEnd == kFirst + 5 * sizeof(double));
  const auto* bytes_of_a = reinterpret_cast<const uint8_t*>(&a);
  const auto* bytes_of_b = reinterpret_cast<const uint8_t*>(&b);
  size_t i = kFirst;
  while (i < kEnd && bytes_of_a[i] == bytes_of_b[i]) {
    ++i;
  }
  return i == kEnd && a.vertical == b.vertical && a.lateral == b.lateral &&
         a.sampling == b.sampling;
}

}  // namespace glider::runtime
