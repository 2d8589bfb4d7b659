// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/imc/course.h"

#include "hooks/imc/values.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/degrees.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;
using hooks::HookLateral;
using hooks::HookVertical;

/// The vehicle settles some decimetres below a depth: one above this is the surface, m.
constexpr double kFloats_m = 1;
constexpr double kRadiansPerDegree = 3.141592653589793 / 180.0;

bool isKnownPlace(const Place& place) {
  return isKnown(place.latitude) && isKnown(place.longitude);
}

}  // namespace

void Course::steer(const hooks::Instruction& command, const Place& here, double heading) {
  const bool same = has_command_ && command.lateral == command_.lateral &&
                    command.heading_rad == command_.heading_rad &&
                    command.latitude_ddmm == command_.latitude_ddmm &&
                    command.longitude_ddmm == command_.longitude_ddmm;
  // With another depth the vehicle is to be given another place as it comes near again.
  arrived_ =
      arrived_ && command.vertical == command_.vertical && command.depth_m == command_.depth_m;
  command_ = command;
  has_command_ = true;
  if (same) {
    return;  // a leg goes on straight: its place is not aimed again from where the current has
             // taken it
  }
  arrived_ = false;
  heading_ = command.lateral == HookLateral::Heading ? command.heading_rad
             : command.lateral == HookLateral::Drift ? heading
                                                     : __builtin_nan("");
  if (command.lateral == HookLateral::Waypoint) {
    aim_ = {degreesOfPosition(command.latitude_ddmm), degreesOfPosition(command.longitude_ddmm)};
  } else {
    aim_ = here;
    aimAhead(here);
  }
}

/// Whether the place of a heading is still so far ahead; a fix may have moved the vehicle past it.
bool Course::isAhead(const Place& here) const {
  constexpr double kCosine = 0.5;  // 60 degrees to either side
  const double away = gliderDistance(here.latitude, here.longitude, aim_.latitude, aim_.longitude);
  const double course = gliderBearing(here.latitude, here.longitude, aim_.latitude, aim_.longitude);
  return away >= kNear_m && gliderCos(course - heading_) > kCosine;
}

void Course::aimAhead(const Place& here) {
  if (isKnown(heading_) && isKnownPlace(here)) {
    aim_ = displaced(here, kAhead_m * gliderCos(heading_), kAhead_m * gliderSin(heading_));
  }
}

/// DUNE flies around a place, instead of on through it, only if it is given a Reference within 15 m
/// that is another one, or if the depth was never changed on the way.
void Course::lookWhetherItArrives(const Place& here) {
  if (isKnownPlace(here) && isKnownPlace(aim_)) {
    const double away =
        gliderDistance(here.latitude, here.longitude, aim_.latitude, aim_.longitude);
    arrived_ = away < (arrived_ ? kLeft_m : kArrived_m);
  }
}

bool Course::reference(const Place& here, Reference& reference) {
  lookWhetherItArrives(here);
  if (has_command_ && isKnown(heading_) && isKnownPlace(here) && !isAhead(here)) {
    aimAhead(here);
  }
  const Place& place = has_command_ && isKnownPlace(aim_) ? aim_ : here;
  if (!isKnownPlace(place)) {
    return false;
  }
  const bool to_depth = has_command_ && (command_.vertical == HookVertical::Descend ||
                                         command_.vertical == HookVertical::Ascend);
  reference.flags = ReferenceFlag::Location | ReferenceFlag::Speed | ReferenceFlag::Z;
  constexpr double kAnother = 1e-9;  // 6 mm
  reference.lat = place.latitude * kRadiansPerDegree + (has_command_ && arrived_ ? kAnother : 0);
  reference.lon = place.longitude * kRadiansPerDegree;
  reference.speed.present = true;
  reference.speed.value.value = to_depth ? command_.pitch_rad : mission_.usual_m_s;
  reference.speed.value.speed_units = SpeedUnits::MetresPerSecond;
  reference.z.present = true;
  reference.z.value.value =
      to_depth && command_.depth_m >= kFloats_m ? static_cast<float>(command_.depth_m) : 0;
  reference.z.value.z_units = ZUnits::Depth;
  return true;
}

}  // namespace glider::runtime::imc
