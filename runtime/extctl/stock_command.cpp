// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/stock_command.h"

#include "hooks/protocol/numbers.h"
#include "runtime/abi/behaviour.h"
#include "runtime/numbers/degrees.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime::extctl {
namespace {

using hooks::HookLateral;
using hooks::HookVertical;

/// Commands to climb to less than this depth mean the surface, m.
constexpr double kFloats = 1;
/// So do commands to dive to less: a yo above this depth is none, m. To refuse them would leave a
/// deeper dive in force.
constexpr double kLeastDive = 2;

/// As hookbeh does: where waves hide the depth, nothing is held.
bool floats(const hooks::Instruction& instruction) {
  return (instruction.vertical == HookVertical::Ascend && instruction.depth_m < kFloats) ||
         (instruction.vertical == HookVertical::Descend && instruction.depth_m < kLeastDive);
}

/// The magnetic heading from `at` to the instruction's waypoint, rad; unknown if the place is.
double headingTo(const hooks::Instruction& instruction, const Whereabouts& at) {
  const double bearing = gliderBearing(
      degreesOfPosition(at.latitude_ddmm), degreesOfPosition(at.longitude_ddmm),
      degreesOfPosition(instruction.latitude_ddmm), degreesOfPosition(instruction.longitude_ddmm));
  const double variation = isKnown(at.variation_rad) ? at.variation_rad : 0;
  const double heading = bearing + variation;
  return heading < 0 ? heading + kTwoPi : heading >= kTwoPi ? heading - kTwoPi : heading;
}

void followLateral(const hooks::Instruction& instruction, const GliderPortMission& port,
                   const Whereabouts& at, StockCommand& stock) {
  stock.modes &= ~static_cast<uint32_t>(kGliderPortModeWaypoint);
  if (instruction.lateral == HookLateral::Heading) {
    stock.heading_rad = instruction.heading_rad;
  } else if (instruction.lateral == HookLateral::Waypoint) {
    stock.waypoint_latitude_ddmm = instruction.latitude_ddmm;
    stock.waypoint_longitude_ddmm = instruction.longitude_ddmm;
    const double heading = headingTo(instruction, at);
    stock.heading_rad = isKnown(heading) ? heading : stock.heading_rad;
    stock.modes |= port.mission_modes != 0 ? kGliderPortModeWaypoint : 0;
  }
}

/// The upper end of the yo, which holds a depth at `held_m`, m. Half of that yo is room enough to
/// turn in. Where the last dive ended above, it met the bottom, or something else turned it: then
/// the upper end is a whole yo above that.
double upperEnd(double held_m, const GliderPortMission& port, const Whereabouts& at,
                const StockCommand& stock) {
  if (at.deep_m >= (held_m + stock.dive_depth_m) / 2) {
    return held_m;
  }
  const double kept_m = hookAtMost(stock.climb_depth_m, held_m);
  return hookAtLeast(hookAtMost(at.deep_m - port.hold_m, kept_m), hooks::extctl::kFirstClimbDepth);
}

void dive(const hooks::Instruction& instruction, const GliderPortMission& port,
          const Whereabouts& at, StockCommand& stock) {
  const double half = instruction.depth_m / 2;
  stock.dive_depth_m = instruction.depth_m;
  const double held_m = instruction.depth_m - (port.hold_m < half ? port.hold_m : half);
  stock.climb_depth_m = upperEnd(held_m, port, at, stock);
  stock.dive_pitch_rad = instruction.pitch_rad;
}

void climb(const hooks::Instruction& instruction, const GliderPortMission& port,
           const Whereabouts& at, StockCommand& stock) {
  const double below = instruction.depth_m + port.hold_m;
  stock.dive_depth_m = below < port.greatest_depth_m ? below : port.greatest_depth_m;
  const double above = stock.dive_depth_m - port.hold_m;
  const double held_m = instruction.depth_m < above || above < 0 ? instruction.depth_m : above;
  stock.climb_depth_m = upperEnd(held_m, port, at, stock);
  stock.climb_pitch_rad = instruction.pitch_rad;
}

}  // namespace

void follow(const hooks::Instruction& instruction, const GliderPortMission& port,
            const Whereabouts& at, StockCommand& stock) {
  followLateral(instruction, port, at, stock);
  const HookVertical vertical = floats(instruction) ? HookVertical::Surface : instruction.vertical;
  stock.surface = vertical == HookVertical::Surface;
  stock.modes &= ~static_cast<uint32_t>(kGliderPortModeSurface);
  switch (vertical) {
    case HookVertical::Descend:
      dive(instruction, port, at, stock);
      break;
    case HookVertical::Ascend:
      climb(instruction, port, at, stock);
      break;
    case HookVertical::Surface:
      stock.modes |= kGliderPortModeSurface;
      stock.climb_depth_m = hooks::extctl::kFirstClimbDepth;  // of the dive that follows
      break;
    case HookVertical::Hover:  // these are refused before
    case HookVertical::Actuators:
    case HookVertical::None:
      break;
  }
}

}  // namespace glider::runtime::extctl
