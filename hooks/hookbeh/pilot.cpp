// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/pilot.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr double kFullCircle = 6.283185307179586;
/// m; farther from its depth than this, hover dives or climbs to reach it.
constexpr double kHoverReachM = 2.0;
/// m; this far beyond the target of a dive its commands are not held: a steep dive would continue
/// for metres.
constexpr double kHoldReachM = 1.0;
/// m; farther off than this, hover has lost its depth.
constexpr double kHoverLostM = 6.0;
/// m; shallower than this, hovering means floating.
constexpr double kSurfaceM = 1.0;
/// m; shallower than this, a climbing vehicle may move only because of waves.
constexpr double kNearSurfaceM = 3.0;

}  // namespace

void Pilot::begin(const Instruction& instruction) {
  in_force_ = instruction;
  stage_ = Stage::Choose;
}

void Pilot::follow(const Instruction& instruction) {
  const Instruction before = in_force_;
  const bool same = instruction.vertical == before.vertical &&
                    instruction.depth_m == before.depth_m &&
                    instruction.pitch_rad == before.pitch_rad;
  in_force_ = instruction;
  if (instruction.vertical == HookVertical::None) {
    in_force_.vertical = before.vertical;
    in_force_.depth_m = before.depth_m;
    in_force_.pitch_rad = before.pitch_rad;
  } else if (!same) {
    stage_ = Stage::Choose;
  }
}

void Pilot::goBack(const Surroundings& now, const HookbehArgs& args, bool checked) {
  const bool arrived = stage_ == Stage::Holding || stage_ == Stage::Hovering;
  const double above_m = in_force_.depth_m - now.depth_m;
  const double reach_m = checked && stage_ == Stage::Hovering ? kHoverLostM : kHoverReachM;
  const HookVertical way = above_m > reach_m    ? HookVertical::Descend
                           : above_m < -reach_m ? HookVertical::Ascend
                                                : HookVertical::None;
  if (!arrived || way == HookVertical::None) {
    return;
  }
  if (in_force_.vertical == way) {
    stage_ = Stage::Choose;  // again, as it was commanded
  } else {
    approach(now, args);
  }
}

VerticalCommand Pilot::vertical(const Surroundings& now, double step_s, const HookbehArgs& args) {
  if (stage_ == Stage::Choose) {
    choose(now, args);
  }
  advance(now, step_s, args);
  switch (stage_) {
    case Stage::Dive:
      return dive_.command(args);
    case Stage::Climb:
      return climb_.command(args);
    case Stage::Holding:
      return hold_.command();
    case Stage::Hovering:
      return hover_.command(now, step_s, args);
    case Stage::Actuators:
      return actuators_.command(args);
    case Stage::Choose:
    case Stage::Surfacing:
      break;
  }
  return surface_.command(args);
}

void Pilot::choose(const Surroundings& now, const HookbehArgs& args) {
  const Instruction& want = in_force_;
  switch (want.vertical) {
    case HookVertical::Descend:
      dive_ = {want.depth_m, want.pitch_rad};
      stage_ = Stage::Dive;
      break;
    case HookVertical::Ascend:
      climb_ = {want.depth_m, want.pitch_rad};
      stage_ = Stage::Climb;
      break;
    case HookVertical::Hover:
      approach(now, args);
      break;
    case HookVertical::Actuators:
      actuators_ = {want.depth_m, want.pitch_rad};
      stage_ = Stage::Actuators;
      break;
    case HookVertical::None:
    case HookVertical::Surface:
      // A mission that has given no vertical command yet (its sensors are unknown) floats up
      // meanwhile.
      stage_ = Stage::Surfacing;
  }
}

/// Dives or climbs to within reach of the hover depth. A vehicle that is already there has arrived
/// at once.
void Pilot::approach(const Surroundings& now, const HookbehArgs& args) {
  const double target_m = in_force_.depth_m;
  if (now.depth_m < target_m) {
    dive_ = {target_m - kHoverReachM, -usualPitch(args)};
    stage_ = Stage::Dive;
  } else if (now.depth_m > target_m) {
    climb_ = {target_m + kHoverReachM, usualPitch(args)};
    stage_ = Stage::Climb;
  } else {
    hoverOrSurface();
  }
}

void Pilot::advance(const Surroundings& now, double step_s, const HookbehArgs& args) {
  if (stage_ == Stage::Dive && dive_.reached(now.depth_m)) {
    arrive(dive_.command(args), args);
    stopDive(now);
  } else if (stage_ == Stage::Climb && climb_.reached(now.depth_m)) {
    arrive(climb_.command(args), args);
  } else if (stage_ == Stage::Holding) {
    hold_.left_s -= step_s;
    if (!(hold_.left_s > 0)) {
      hoverOrSurface();
    }
    stopDive(now);
  }
}

void Pilot::stopDive(const Surroundings& now) {
  const bool beyond = now.depth_m > in_force_.depth_m + kHoldReachM;
  if (beyond && in_force_.vertical == HookVertical::Descend) {
    hoverOrSurface();
  }
}

void Pilot::arrive(const VerticalCommand& kept, const HookbehArgs& args) {
  const HookVertical way = stage_ == Stage::Dive ? HookVertical::Descend : HookVertical::Ascend;
  if (in_force_.vertical != way || !(args.hold_secs > 0)) {  // an approach does not command a hold
    hoverOrSurface();
    return;
  }
  hold_ = {kept, args.hold_secs};
  stage_ = Stage::Holding;
}

void Pilot::hoverOrSurface() {
  hover_ = Hover(in_force_.depth_m);
  stage_ = in_force_.depth_m < kSurfaceM ? Stage::Surfacing : Stage::Hovering;
}

Way Pilot::way(double depth_m) const {
  switch (stage_) {
    case Stage::Dive:
      return Way::Down;
    case Stage::Climb:
      return Way::Up;
    case Stage::Hovering:
      return depth_m > hover_.target() + kHoverLostM   ? Way::Up
             : depth_m < hover_.target() - kHoverLostM ? Way::Down
                                                       : Way::None;
    case Stage::Surfacing:
      return depth_m > kNearSurfaceM ? Way::Up : Way::None;
    case Stage::Actuators:
      return actuators_.dives() ? Way::Down : Way::None;
    case Stage::Holding:  // no dive by more than a metre
    case Stage::Choose:
      break;
  }
  return Way::None;
}

LateralCommand Pilot::lateral(const Surroundings& now) const {
  if (in_force_.lateral == HookLateral::Heading) {
    const double heading = in_force_.heading_rad;
    return {HeadingMode::Heading, heading < 0 ? heading + kFullCircle : heading};
  }
  if (in_force_.lateral == HookLateral::Fin) {
    return {HeadingMode::Fin, 0, 0, 0, in_force_.heading_rad};
  }
  // A vehicle that does not know its position cannot steer to a place: go straight ahead until it
  // does.
  const bool knows_place = isFinite(now.latitude_ddmm) && isFinite(now.longitude_ddmm);
  if (in_force_.lateral == HookLateral::Waypoint && knows_place) {
    return {HeadingMode::Waypoint, 0, in_force_.latitude_ddmm, in_force_.longitude_ddmm};
  }
  return {};
}

}  // namespace glider::hooks
