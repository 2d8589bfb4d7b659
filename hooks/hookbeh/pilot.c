// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/pilot.h"

#include "hooks/protocol/c_library.h"
#include "hooks/protocol/numbers.h"

static const double kFullCircle = 6.283185307179586;
/// m; farther from its depth than this, hover dives or climbs to reach it.
static const double kHoverReachM = 2.0;
/// m; this far beyond the target of a dive its commands are not held: a steep dive would continue
/// for metres.
static const double kHoldReachM = 1.0;
/// m; farther off than this, hover has lost its depth.
static const double kHoverLostM = 6.0;
/// m; shallower than this, hovering means floating.
static const double kSurfaceM = 1.0;
/// m; shallower than this, a climbing vehicle may move only because of waves.
static const double kNearSurfaceM = 3.0;

enum {
  kStageChoose,
  kStageDive,
  kStageClimb,
  kStageHolding,
  kStageHovering,
  kStageSurfacing,
  kStageActuators
};

void hookPilotInit(HookPilot* pilot) {
  memset(pilot, 0, sizeof *pilot);
  hookHoverInit(&pilot->hover, 0);
}

void hookPilotBegin(HookPilot* pilot, const HookInstruction* instruction) {
  pilot->in_force = *instruction;
  pilot->stage = kStageChoose;
}

void hookPilotFollow(HookPilot* pilot, const HookInstruction* instruction) {
  const HookInstruction before = pilot->in_force;
  const bool same = instruction->vertical == before.vertical &&
                    instruction->depth_m == before.depth_m &&
                    instruction->pitch_rad == before.pitch_rad;
  pilot->in_force = *instruction;
  if (instruction->vertical == kHookVerticalNone) {
    pilot->in_force.vertical = before.vertical;
    pilot->in_force.depth_m = before.depth_m;
    pilot->in_force.pitch_rad = before.pitch_rad;
  } else if (!same) {
    pilot->stage = kStageChoose;
  }
}

static HookSlope slopeTo(double target_m, double pitch_rad) {
  const HookSlope slope = {target_m, pitch_rad};
  return slope;
}

static void hoverOrSurface(HookPilot* pilot) {
  hookHoverInit(&pilot->hover, pilot->in_force.depth_m);
  pilot->stage = pilot->in_force.depth_m < kSurfaceM ? kStageSurfacing : kStageHovering;
}

/// Dives or climbs to within reach of the hover depth. A vehicle that is already there has arrived
/// at once.
static void approachDepth(HookPilot* pilot, const HookSurroundings* now, const HookbehArgs* args) {
  const double target_m = pilot->in_force.depth_m;
  if (now->depth_m < target_m) {
    pilot->dive = slopeTo(target_m - kHoverReachM, -hookUsualPitch(args));
    pilot->stage = kStageDive;
  } else if (now->depth_m > target_m) {
    pilot->climb = slopeTo(target_m + kHoverReachM, hookUsualPitch(args));
    pilot->stage = kStageClimb;
  } else {
    hoverOrSurface(pilot);
  }
}

void hookPilotGoBack(HookPilot* pilot, const HookSurroundings* now, const HookbehArgs* args,
                     bool checked) {
  const bool arrived = pilot->stage == kStageHolding || pilot->stage == kStageHovering;
  const double above_m = pilot->in_force.depth_m - now->depth_m;
  const double reach_m = checked && pilot->stage == kStageHovering ? kHoverLostM : kHoverReachM;
  const HookVertical way = above_m > reach_m    ? kHookVerticalDescend
                           : above_m < -reach_m ? kHookVerticalAscend
                                                : kHookVerticalNone;
  if (!arrived || way == kHookVerticalNone) {
    return;
  }
  if (pilot->in_force.vertical == way) {
    pilot->stage = kStageChoose;  // again, as it was commanded
  } else {
    approachDepth(pilot, now, args);
  }
}

static void chooseStage(HookPilot* pilot, const HookSurroundings* now, const HookbehArgs* args) {
  const HookInstruction* want = &pilot->in_force;
  switch (want->vertical) {
    case kHookVerticalDescend:
      pilot->dive = slopeTo(want->depth_m, want->pitch_rad);
      pilot->stage = kStageDive;
      break;
    case kHookVerticalAscend:
      pilot->climb = slopeTo(want->depth_m, want->pitch_rad);
      pilot->stage = kStageClimb;
      break;
    case kHookVerticalHover:
      approachDepth(pilot, now, args);
      break;
    case kHookVerticalActuators:
      pilot->actuators.pump_cc = want->depth_m;
      pilot->actuators.battery_in = want->pitch_rad;
      pilot->stage = kStageActuators;
      break;
    case kHookVerticalNone:
    case kHookVerticalSurface:
      // A mission that has given no vertical command yet (its sensors are unknown) floats up
      // meanwhile.
      pilot->stage = kStageSurfacing;
  }
}

static void arriveAt(HookPilot* pilot, const HookbehArgs* args) {
  const HookVertical way = pilot->stage == kStageDive ? kHookVerticalDescend : kHookVerticalAscend;
  // An approach does not command a hold.
  if (pilot->in_force.vertical != way || !(args->hold_secs > 0)) {
    hoverOrSurface(pilot);
    return;
  }
  if (pilot->stage == kStageDive) {
    hookDiveToCommand(&pilot->dive, args, &pilot->hold.kept);
  } else {
    hookClimbToCommand(&pilot->climb, args, &pilot->hold.kept);
  }
  pilot->hold.left_s = args->hold_secs;
  pilot->stage = kStageHolding;
}

static void stopDive(HookPilot* pilot, const HookSurroundings* now) {
  const bool beyond = now->depth_m > pilot->in_force.depth_m + kHoldReachM;
  if (beyond && pilot->in_force.vertical == kHookVerticalDescend) {
    hoverOrSurface(pilot);
  }
}

static void advanceStage(HookPilot* pilot, const HookSurroundings* now, double step_s,
                         const HookbehArgs* args) {
  if (pilot->stage == kStageDive && now->depth_m >= pilot->dive.target_m) {
    arriveAt(pilot, args);
    stopDive(pilot, now);
  } else if (pilot->stage == kStageClimb && now->depth_m <= pilot->climb.target_m) {
    arriveAt(pilot, args);
  } else if (pilot->stage == kStageHolding) {
    pilot->hold.left_s -= step_s;
    if (!(pilot->hold.left_s > 0)) {
      hoverOrSurface(pilot);
    }
    stopDive(pilot, now);
  }
}

void hookPilotVertical(HookPilot* pilot, const HookSurroundings* now, double step_s,
                       const HookbehArgs* args, HookVerticalCommand* command) {
  if (pilot->stage == kStageChoose) {
    chooseStage(pilot, now, args);
  }
  advanceStage(pilot, now, step_s, args);
  switch (pilot->stage) {
    case kStageDive:
      hookDiveToCommand(&pilot->dive, args, command);
      return;
    case kStageClimb:
      hookClimbToCommand(&pilot->climb, args, command);
      return;
    case kStageHolding:
      hookHoldCommand(&pilot->hold, command);
      return;
    case kStageHovering:
      hookHoverCommand(&pilot->hover, now, step_s, args, command);
      return;
    case kStageActuators:
      hookActuatorsCommand(&pilot->actuators, args, command);
      return;
    case kStageChoose:
    case kStageSurfacing:
      break;
  }
  hookSurfaceCommand(args, command);
}

HookWay hookPilotWay(const HookPilot* pilot, double depth_m) {
  switch (pilot->stage) {
    case kStageDive:
      return kHookWayDown;
    case kStageClimb:
      return kHookWayUp;
    case kStageHovering:
      return depth_m > pilot->hover.target_m + kHoverLostM   ? kHookWayUp
             : depth_m < pilot->hover.target_m - kHoverLostM ? kHookWayDown
                                                             : kHookWayNone;
    case kStageSurfacing:
      return depth_m > kNearSurfaceM ? kHookWayUp : kHookWayNone;
    case kStageActuators:
      return hookActuatorsDive(&pilot->actuators) ? kHookWayDown : kHookWayNone;
    case kStageHolding:  // no dive by more than a metre
    case kStageChoose:
      break;
  }
  return kHookWayNone;
}

void hookPilotLateral(const HookPilot* pilot, const HookSurroundings* now,
                      HookLateralCommand* command) {
  const HookInstruction* want = &pilot->in_force;
  command->mode = kHookHeadingModeCentreFin;
  command->heading_rad = command->latitude_ddmm = command->longitude_ddmm = command->fin_rad = 0;
  if (want->lateral == kHookLateralHeading) {
    const double heading = want->heading_rad;
    command->mode = kHookHeadingModeHeading;
    command->heading_rad = heading < 0 ? heading + kFullCircle : heading;
  }
  if (want->lateral == kHookLateralFin) {
    command->mode = kHookHeadingModeFin;
    command->fin_rad = want->heading_rad;
  }
  // A vehicle that does not know its position cannot steer to a place: go straight ahead until it
  // does.
  const bool knows_place = hookIsFinite(now->latitude_ddmm) && hookIsFinite(now->longitude_ddmm);
  if (want->lateral == kHookLateralWaypoint && knows_place) {
    command->mode = kHookHeadingModeWaypoint;
    command->latitude_ddmm = want->latitude_ddmm;
    command->longitude_ddmm = want->longitude_ddmm;
  }
}
