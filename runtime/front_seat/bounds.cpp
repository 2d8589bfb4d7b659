// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/front_seat/bounds.h"

#include "runtime/numbers/degrees.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

using hooks::HookAnswer;
using hooks::HookLateral;
using hooks::HookVertical;

/// Half a step of a number on the line (hooks/protocol/steps.h), and more.
constexpr double kRounded = 1e-3;

HookAnswer checkVertical(const hooks::Instruction& instruction, const CommandLimits& limits) {
  if (instruction.vertical == HookVertical::Surface) {
    return HookAnswer::Accepted;
  }
  if (instruction.vertical != HookVertical::Descend &&
      instruction.vertical != HookVertical::Ascend) {
    return HookAnswer::BadCommand;
  }
  if (!isFinite(instruction.depth_m) || !isFinite(instruction.pitch_rad)) {
    return HookAnswer::BadCommand;
  }
  if (instruction.depth_m > limits.greatest_depth_m + kRounded) {
    return HookAnswer::TooDeep;
  }
  return instruction.pitch_rad >= limits.slowest_m_s - kRounded &&
                 instruction.pitch_rad <= limits.fastest_m_s + kRounded
             ? HookAnswer::Accepted
             : HookAnswer::BadPitch;
}

HookAnswer checkLateral(const hooks::Instruction& instruction) {
  constexpr double kPole = 90, kHalfTurn = 180;
  switch (instruction.lateral) {
    case HookLateral::Drift:
      return HookAnswer::Accepted;
    case HookLateral::Heading:
      return isFinite(instruction.heading_rad) ? HookAnswer::Accepted : HookAnswer::BadCommand;
    case HookLateral::Waypoint:
      return magnitude(degreesOfPosition(instruction.latitude_ddmm)) <= kPole &&
                     magnitude(degreesOfPosition(instruction.longitude_ddmm)) <= kHalfTurn
                 ? HookAnswer::Accepted
                 : HookAnswer::NotOnEarth;
    case HookLateral::Fin:
      break;
  }
  return HookAnswer::BadCommand;
}

}  // namespace

HookAnswer checkBounds(const hooks::Instruction& instruction, const CommandLimits& limits) {
  const HookAnswer vertical = checkVertical(instruction, limits);
  return vertical == HookAnswer::Accepted ? checkLateral(instruction) : vertical;
}

}  // namespace glider::runtime
