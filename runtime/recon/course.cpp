// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/recon/course.h"

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/degrees.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime::recon {
namespace {

using hooks::HookLateral;
using hooks::HookVertical;

/// A depth above this is the surface, m.
constexpr double kFloats_m = 1;

}  // namespace

void Course::steer(const hooks::Instruction& command, double heading) {
  const bool drifts_on = has_command_ && command_.lateral == HookLateral::Drift;
  kept_heading_ = drifts_on && isKnown(kept_heading_) ? kept_heading_ : heading;
  command_ = command;
  has_command_ = true;
}

/// Unknown if the vehicle's own heading is to be kept and it is not known.
double Course::headingNow(const Place& here, double heading) const {
  if (!has_command_) {
    return heading;
  }
  if (command_.lateral == HookLateral::Heading) {
    return command_.heading_rad;
  }
  if (command_.lateral == HookLateral::Waypoint) {
    const double bearing =
        gliderBearing(here.latitude, here.longitude, degreesOfPosition(command_.latitude_ddmm),
                      degreesOfPosition(command_.longitude_ddmm));
    return isKnown(bearing) ? bearing : heading;
  }
  return isKnown(kept_heading_) ? kept_heading_ : heading;
}

bool Course::goals(const Place& here, double heading, Goals& goals) const {
  const double wanted = headingNow(here, heading);
  if (!isFinite(wanted)) {
    return false;
  }
  const bool to_depth = has_command_ && (command_.vertical == HookVertical::Descend ||
                                         command_.vertical == HookVertical::Ascend);
  const double turn = restOf(magnitude(wanted), kTwoPi);
  goals.heading_deg = (wanted < 0 && turn > 0 ? kTwoPi - turn : turn) * kDegreesPerRadian;
  goals.speed_m_s = to_depth       ? command_.pitch_rad
                    : has_command_ ? mission_.usual_m_s
                                   : mission_.slowest_m_s;
  goals.depth_m = to_depth && command_.depth_m >= kFloats_m ? command_.depth_m : 0;
  return true;
}

}  // namespace glider::runtime::recon
