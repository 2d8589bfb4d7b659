// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/command_judge.h"

#include "hooks/hookbeh/hookbeh.h"
#include "hooks/protocol/numbers.h"
#include "vehicles/slocum/oracles/commanded.h"
#include "vehicles/slocum/oracles/judge_limits.h"
#include "vehicles/slocum/oracles/wrong_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace glider::slocum::oracles {

using hooks::HookAnswer;
using hooks::HookbehOutputs;
using hooks::HookControl;
using hooks::HookLateral;
using hooks::HookState;
using hooks::HookVertical;
using hooks::Instruction;

namespace {

constexpr double kPitchError = 1e-5;         // rad
constexpr double kCommandDepthError = 1e-3;  // m
constexpr double kHoverReach = 2;            // m: hookbeh's own
constexpr double kHoldReach = 1;             // m: the same
constexpr double kFloats = 1;                // m: a target above this is the surface
constexpr double kFarFromTarget = 6;         // m
constexpr int kFarCycles = 15;               // a minute
constexpr int kToArrive = 6;  // cycles that the commands of a dive or climb may be held
constexpr double kSwing = 4;  // m: a climb of the guard is at least 5 m
constexpr int kSmallSwings = 3;
constexpr double kOldReading = 30;      // s: hookbeh's guard 6 steps in within this time
constexpr double kAfterOverride = 300;  // s
constexpr double kSeesOverride = 8;     // s
constexpr double kRetryShare = 0.5, kRetry = 5, kRetryTolerance = 3;  // of the guard's climb
constexpr int kLate = 4;                                              // cycles
// s; a climb of a guard as brief as that turns the vehicle, which then is late in the next dive.
constexpr double kBrief = 20, kTurnsBack = 90;
// A depth that cannot be believed: hookbeh's own limits, plus two cycles.
constexpr double kFar = 1e9;        // m
constexpr double kLongAgo = -1e9;   // s
constexpr double kHighest = -5;     // m
constexpr double kFrozenSecs = 24;  // of a dive, deeper than a metre
// The same where the depth is new in few cycles: hookbeh waits for twice its usual time, up to 36
// s.
constexpr double kRareFrozenSecs = 44;
constexpr double kWrong = 8;         // m from the truth, if there is a CTD
constexpr double kWrongSecs = 60;    // of a dive; an error at its beginning takes as long to show
constexpr double kIdleSecs = 200;    // a dive that does not gain depth
constexpr double kCreepsSecs = 380;  // one that gains it slowly: hookbeh may wait 2 x 180 s
constexpr double kCommandJump = 4;   // m per cycle
constexpr double kHeardSecs = 40;    // s: hookbeh's own, for which an echo counts fully
constexpr double kStands = 0.3;      // m; a smaller gain counts as none
constexpr double kLateSecs = 3;      // s, beyond the usual 8: in 11 s the vehicle sinks by 5 m
constexpr double kCtdFades = 300;    // s; after a fault the CTD must agree again, at the surface
constexpr double kExcused = 600;     // s after such a climb: to the surface, and back to the depth
constexpr double kFarInCc = 100;     // a commanded pump that counts as a dive
constexpr double kFullCircle = 6.283191;
/// Instructions, and the limits that they are compared with, are whole numbers of so many parts of
/// a radian and of a metre.
constexpr double kAngle = 100000, kDepth = 1000;

bool isAngle(double ddmm, double most) {
  return std::fabs(ddmm) <= most && std::fmod(std::fabs(ddmm), 100) <= 60;
}

Instruction merged(const Instruction& before, Instruction next) {
  if (next.control != HookControl::Take && next.vertical == HookVertical::None) {
    next.vertical = before.vertical;
    next.depth_m = before.depth_m;
    next.pitch_rad = before.pitch_rad;
  }
  return next;
}

bool sameVertical(const Instruction& a, const Instruction& b) {
  return a.vertical == b.vertical && a.depth_m == b.depth_m && a.pitch_rad == b.pitch_rad;
}

}  // namespace

/// Accepted, or the reason for a refusal, according to the b_args.
HookAnswer CommandJudge::boundsOf(const Instruction& instruction) const {
  const auto fits = [&](double pitch) {
    return std::round(pitch * kAngle) >= std::round(s_.args.shallowest_pitch_rad * kAngle) &&
           std::round(pitch * kAngle) <= std::round(s_.args.steepest_pitch_rad * kAngle);
  };
  const double depth = instruction.depth_m;
  const bool deep = instruction.vertical == HookVertical::Descend ||
                    instruction.vertical == HookVertical::Ascend ||
                    instruction.vertical == HookVertical::Hover;
  if (deep && !(depth >= 0 && std::isfinite(depth))) {
    return HookAnswer::BadCommand;
  }
  if (deep && std::round(depth * kDepth) > std::round(s_.args.greatest_depth_m * kDepth)) {
    return HookAnswer::TooDeep;
  }
  if ((instruction.vertical == HookVertical::Descend && !fits(-instruction.pitch_rad)) ||
      (instruction.vertical == HookVertical::Ascend && !fits(instruction.pitch_rad))) {
    return HookAnswer::BadPitch;
  }
  if (instruction.vertical == HookVertical::Actuators) {
    if (!(std::fabs(depth) <= hookAsFloat32(s_.args.greatest_pump_cc))) {
      return HookAnswer::BadPump;
    }
    if (!(std::fabs(instruction.pitch_rad) <= hookAsFloat32(s_.args.greatest_battery_in))) {
      return HookAnswer::BadBattery;
    }
  }
  if (instruction.lateral == HookLateral::Waypoint &&
      !(isAngle(instruction.latitude_ddmm, 9000) && isAngle(instruction.longitude_ddmm, 18000))) {
    return HookAnswer::NotOnEarth;
  }
  if (instruction.lateral == HookLateral::Fin) {
    const double most = std::round(s_.args.greatest_fin_rad * kAngle);
    return std::round(std::fabs(instruction.heading_rad) * kAngle) <= most ? HookAnswer::Accepted
                                                                           : HookAnswer::BadFin;
  }
  const bool turns = instruction.lateral == HookLateral::Heading;
  return turns && !(std::fabs(instruction.heading_rad) <= kFullCircle) ? HookAnswer::BadCommand
                                                                       : HookAnswer::Accepted;
}

std::string CommandJudge::answered(const Instruction& instruction, HookAnswer answer) {
  const bool steers = instruction.control != HookControl::Release;
  const HookAnswer bounds = steers ? boundsOf(instruction) : HookAnswer::Accepted;
  const bool of_bounds = answer == HookAnswer::TooDeep || answer == HookAnswer::BadPitch ||
                         answer == HookAnswer::NotOnEarth || answer == HookAnswer::BadFin ||
                         answer == HookAnswer::BadPump || answer == HookAnswer::BadBattery;
  if (answer == HookAnswer::Accepted && bounds != HookAnswer::Accepted) {
    return fmt::format("instruction {} is obeyed though it is outside the b_args",
                       instruction.sequence);
  }
  if (of_bounds && bounds != answer) {
    return fmt::format("instruction {} is refused without a valid reason", instruction.sequence);
  }
  if (answer == HookAnswer::Accepted && steers) {
    const Instruction next = merged(in_force_, instruction);
    if (instruction.control == HookControl::Take || !sameVertical(next, in_force_)) {
      arrived_ = goes_back_ = carried_off_ = false;
      arrived_cycles_ = far_cycles_ = late_cycles_ = small_swings_ = 0;
    }
    in_force_ = next;
  }
  return "";
}

void CommandJudge::restart() {
  in_force_ = {};
  arrived_ = goes_back_ = carried_off_ = guarding_ = false;
  same_s_ = wrong_s_ = idle_s_ = 0;
  deepest_m_ = crept_m_ = -kFar;
}

std::string CommandJudge::judgeWhole(const CycleView& view) const {
  const HookbehOutputs& out = *view.hookbeh;
  const bool whole = out.commanding && view.commanded_whole && std::isfinite(out.pitch_rad) &&
                     std::isfinite(out.pump_cc) && std::isfinite(out.heading_rad) &&
                     std::isfinite(out.latitude_ddmm) && std::isfinite(out.longitude_ddmm) &&
                     std::isfinite(out.fin_rad) && std::isfinite(out.battery_in);
  if (!whole) {
    return "heading, pitch and pump are not all commanded";
  }
  const bool named = hookIsGuard(out.doing);
  if (named != (out.guard != hooks::HookGuard::None) ||
      view.array.get(Sensor::x_hook_guard) != static_cast<double>(out.guard)) {
    return fmt::format("x_hook_guard does not show `{}`", hookWordsForDoing(out.doing));
  }
  if (view.mission_s < s_.args.start_secs) {
    return "the SBC is in control before start_secs";
  }
  if (std::fabs(out.pitch_rad) > s_.args.steepest_pitch_rad + kPitchError) {
    return fmt::format("a pitch of {:.2f} rad is commanded under max_pitch {}", out.pitch_rad,
                       s_.args.steepest_pitch_rad);
  }
  if (std::fabs(out.fin_rad) > s_.args.greatest_fin_rad + kPitchError) {
    return fmt::format("a fin of {:.2f} rad is commanded under max_fin {}", out.fin_rad,
                       s_.args.greatest_fin_rad);
  }
  if (out.pitch_mode == hooks::PitchMode::Battery) {
    const bool within = std::fabs(out.pump_cc) <= s_.args.greatest_pump_cc + kPumpError &&
                        std::fabs(out.battery_in) <= s_.args.greatest_battery_in + kPitchError;
    return within ? ""
                  : fmt::format("a pump of {:.0f} cc and a battery of {:.2f} in are commanded",
                                out.pump_cc, out.battery_in);
  }
  // Its own climbs use the full pump range.
  const double most_cc = climbsByItself(out) ? s_.pump_cc : s_.args.climb_pump_cc;
  if (out.pump_cc > most_cc + kPumpError || out.pump_cc < s_.args.dive_pump_cc - kPumpError) {
    return fmt::format("a pump of {:.0f} cc is commanded", out.pump_cc);
  }
  return "";
}

/// Checks for a broken limit: by hookbeh's own depth reading, and by the true distance to a bottom
/// that the altimeter detects.
std::string CommandJudge::judgeLimits(const CycleView& view, double reading) {
  const bool too_deep =
      !(reading <= s_.args.greatest_depth_m + kCommandDepthError && reading >= kHighest);
  const bool echoes = s_.echo_every_s <= limits::kRareEchoSecs &&
                      !isWrong(s_.faults, {"m_altitude"}, view.time_s, limits::kEchoFadesSecs);
  // Nearer than 2 m the altimeter receives none, as after a time without a flight controller.
  const bool heard = echo_.age() <= kHeardSecs;
  const bool too_low = s_.promiseAt(view.time_s).clearance && echoes && heard &&
                       s_.args.least_altitude_m >= 0 &&
                       view.clearance_m < s_.args.least_altitude_m - 1;
  too_deep_cycles_ = too_deep ? too_deep_cycles_ + 1 : 0;
  too_low_cycles_ = too_low ? too_low_cycles_ + 1 : 0;
  if (climbs(*view.hookbeh)) {
    return "";
  }
  if (too_deep_cycles_ > 1) {
    return std::isnan(reading)
               ? "the depth is unknown, and hookbeh does not climb"
               : fmt::format("m_depth says {:.1f} m, and hookbeh does not climb", reading);
  }
  return too_low_cycles_ > 3
             ? fmt::format("{:.1f} m over the bottom, and hookbeh does not climb", view.clearance_m)
             : "";
}

/// Checks for dives by a depth that is frozen, wrong or does not increase.
std::string CommandJudge::judgeBlind(const CycleView& view, double reading) {
  const HookbehOutputs& out = *view.hookbeh;
  const bool sinks = out.pitch_mode == hooks::PitchMode::Battery && out.pump_cc <= -kFarInCc;
  const bool dives = (out.pitch_rad < 0 || sinks) && !view.overridden();
  const auto lasts = [&](double& seconds, bool so) {
    seconds = dives && so ? seconds + s_.cycle_s : 0;
    return seconds;
  };
  const bool ctd =
      s_.has_ctd && !isWrong(s_.faults, {"sci_water_pressure"}, view.time_s, kCtdFades);
  // Each dive counts from its own first reading; NaN readings are checked elsewhere.
  const bool gains = !dives || !(reading < deepest_m_ + 1);
  deepest_m_ = !dives ? -kFar : gains ? reading : deepest_m_;
  crept_m_ = gains ? deepest_m_ : std::max(crept_m_, reading);
  const double same = lasts(same_s_, reading == reading_m_ && reading > kFloats);
  const double wrong = lasts(wrong_s_, ctd && std::fabs(reading - view.true_depth_m) > kWrong);
  const double idle = lasts(idle_s_, !gains);
  if (std::fabs(reading - reading_m_) > kCommandJump) {
    same_s_ = -s_.cycle_s;  // hookbeh believes a reading that has jumped one cycle later
  }
  reading_m_ = reading;
  const bool rare = s_.late_m > 0 || isSeldom(s_.faults, {"m_depth"}, view.time_s, kRareFrozenSecs);
  return same > (rare ? kRareFrozenSecs : kFrozenSecs)
             ? fmt::format("dives for {:.0f} s by a depth that is frozen", same)
         : wrong > kWrongSecs
             ? fmt::format("dives at {:.1f} m by a depth of {:.1f} m", view.true_depth_m, reading)
         : idle > (crept_m_ < deepest_m_ + kStands ? kIdleSecs : kCreepsSecs)
             ? fmt::format("dives for {:.0f} s without a metre gained", idle)
             : "";
}

/// Checks that the guard steps in only at a limit, ends its climb in time, and does not oscillate.
std::string CommandJudge::judgeGuard(const CycleView& view) {
  const bool guards = view.hookbeh->guard != hooks::HookGuard::None;
  const bool no_depth = view.hookbeh->guard == hooks::HookGuard::NoDepthGained;
  const double depth = view.true_depth_m;
  const bool near = isNearLimit(s_, view, view.hookbeh->guard, echo_.ageOfWhatHookbehKnows());
  std::string wrong;
  if (guards && !guarding_) {
    // A vehicle that another behaviour steers gains no depth, regardless of what hookbeh commands.
    const bool stalled = no_depth || view.hookbeh->guard == hooks::HookGuard::NoHeightGained;
    const bool was_before = no_depth && no_depth_gained_;
    const bool turns = no_depth && view.time_s - brief_s_ < kTurnsBack;
    if (!near && !was_before && !turns &&
        !(stalled && view.time_s - overridden_s_ < kAfterOverride)) {
      wrong = fmt::format("the guard intervenes ({}), but no limit is near",
                          hookWordsForDoing(view.hookbeh->doing));
    }
    // In water too shallow for such a climb the vehicle surfaces, and waits until the echo is
    // forgotten.
    const bool small = tripped_m_ - shallowest_m_ < kSwing && shallowest_m_ > kFloats &&
                       std::isfinite(shallowest_m_);
    small_swings_ = small ? small_swings_ + 1 : 0;
    if (small_swings_ >= kSmallSwings) {
      wrong = fmt::format("the guard swings by less than {} m", kSwing);
    }
    tripped_m_ = shallowest_m_ = near_m_ = depth;
    tripped_s_ = view.time_s;
  }
  // The climb counts from where the limit is no longer near: an old echo may be of a bottom that
  // has risen.
  near_m_ = guards && near ? std::min(near_m_, depth) : near_m_;
  brief_s_ = guarding_ && !guards && view.time_s - tripped_s_ < kBrief ? view.time_s : brief_s_;
  goes_back_ = goes_back_ || (guarding_ && !guards && arrived_);
  guarding_ = guards;
  no_depth_gained_ = no_depth;
  shallowest_m_ = std::min(shallowest_m_, depth);
  const double enough = std::max(kRetryShare * near_m_, kRetry) + kRetryTolerance;
  const bool late = guards && !near && near_m_ - depth > enough;
  late_cycles_ = late ? late_cycles_ + 1 : 0;
  return late_cycles_ > kLate ? "the guard does not release control" : wrong;
}

std::string CommandJudge::judgeDive(const HookbehOutputs& out, double reading) {
  const double target = in_force_.depth_m;
  if (!arrived_ && reading < target - kCommandDepthError) {
    // hookbeh's own climb first checks that the depth follows, then it dives.
    const bool dives = std::fabs(out.pitch_rad - in_force_.pitch_rad) < kPitchError &&
                       out.pump_cc < s_.args.dive_pump_cc + kPumpError;
    return dives || checksDepth(out) ? ""
                                     : fmt::format("no dive to {} m though it is in force", target);
  }
  arrived_ = true;
  if (reading > target + kHoldReach + kCommandDepthError && out.pitch_rad < 0) {
    return fmt::format("still diving {:.1f} m past {} m", reading - target, target);
  }
  return "";
}

std::string CommandJudge::judgeClimb(const HookbehOutputs& out, double reading) {
  const double target = in_force_.depth_m;
  if (!arrived_ && reading > target + kCommandDepthError) {
    // hookbeh's own climb leads there at another pitch.
    const bool as_told =
        checksDepth(out) || std::fabs(out.pitch_rad - in_force_.pitch_rad) < kPitchError;
    const bool rises = climbs(out) && as_told && out.pump_cc > s_.args.climb_pump_cc - kPumpError;
    return rises ? "" : fmt::format("no climb to {} m though it is in force", target);
  }
  arrived_ = true;
  return "";
}

std::string CommandJudge::judgeHover(const HookbehOutputs& out, double reading) {
  const double above = in_force_.depth_m - reading;
  if (!arrived_ && std::fabs(above) > kHoverReach + kCommandDepthError) {
    const bool goes = above > 0 ? out.pitch_rad < 0 : out.pitch_rad > 0;
    return goes || checksDepth(out)
               ? ""
               : fmt::format("no way to {} m though it is in force", in_force_.depth_m);
  }
  arrived_ = true;
  return "";
}

/// Checks a vehicle at a depth that was reached, or on the way back to it.
std::string CommandJudge::judgeStaying(const CycleView& view, double reading) {
  const HookbehOutputs& out = *view.hookbeh;
  const double off = std::fabs(reading - in_force_.depth_m);
  arrived_cycles_ = arrived_ ? arrived_cycles_ + 1 : 0;
  // While another behaviour steers it waits, and it learns a cycle later that none does.
  const bool alone = view.time_s - overridden_s_ > kSeesOverride;
  if (goes_back_ && off > kHoverReach + kHoldReach && out.pitch_rad == 0 && alone) {
    return fmt::format("no way back to {} m", in_force_.depth_m);
  }
  goes_back_ = goes_back_ && off > kHoverReach;
  const bool floats = in_force_.depth_m < kFloats;
  if (floats && arrived_cycles_ > kToArrive && !climbs(out)) {
    return fmt::format("a target of {} m does not end in floating", in_force_.depth_m);
  }
  carried_off_ = carried_off_ && off > kHoverReach;
  const bool far =
      arrived_ && !carried_off_ && !floats && off > kFarFromTarget && out.pitch_rad == 0;
  far_cycles_ = far ? far_cycles_ + 1 : 0;
  return far_cycles_ > kFarCycles ? fmt::format("hovers {:.1f} m from its depth", off) : "";
}

std::string CommandJudge::judgeFin(const HookbehOutputs& out) const {
  const bool held = out.heading_mode == hooks::HeadingMode::Fin;
  const bool wanted = in_force_.lateral == HookLateral::Fin;
  if (held != wanted) {
    return wanted ? fmt::format("the fin is not held though {:.4g} rad is commanded",
                                in_force_.heading_rad)
                  : "the fin is held though no angle of it is commanded";
  }
  return !held || out.fin_rad == in_force_.heading_rad
             ? ""
             : fmt::format("the fin is held at {:.4g} rad though {:.4g} rad is commanded",
                           out.fin_rad, in_force_.heading_rad);
}

std::string CommandJudge::judgeActuators(const HookbehOutputs& out) const {
  const bool wanted = in_force_.vertical == HookVertical::Actuators;
  const bool held = out.pitch_mode == hooks::PitchMode::Battery;
  if (!wanted) {
    return held ? "the pitch battery is held though no position of it is commanded" : "";
  }
  if (checksDepth(out)) {
    return "";
  }
  return held && out.pump_cc == in_force_.depth_m && out.battery_in == in_force_.pitch_rad
             ? ""
             : fmt::format(
                   "pump and battery are not at {:.4g} cc and {:.4g} in though this is in "
                   "force",
                   in_force_.depth_m, in_force_.pitch_rad);
}

std::string CommandJudge::judgeFollowing(const CycleView& view, double reading) {
  const HookbehOutputs& out = *view.hookbeh;
  std::string wrong = judgeFin(out);
  wrong = wrong.empty() ? judgeActuators(out) : wrong;
  if (!wrong.empty()) {
    return wrong;
  }
  switch (in_force_.vertical) {
    case HookVertical::Actuators:
      return "";
    case HookVertical::None:
    case HookVertical::Surface:
      return climbs(out) ? "" : "no way up though it is in force";
    case HookVertical::Descend:
      wrong = judgeDive(out, reading);
      break;
    case HookVertical::Ascend:
      wrong = judgeClimb(out, reading);
      break;
    case HookVertical::Hover:
      wrong = judgeHover(out, reading);
      break;
  }
  return wrong.empty() && arrived_ ? judgeStaying(view, reading) : wrong;
}

namespace {

/// Whether frames are repeated on the line to the flight computer, or were until recently: they
/// carry old readings of the CTD, which the hooks cannot distinguish from new ones, as does a line
/// that is late.
bool oldFramesReachFlight(const Faults& faults, double now_s) {
  return std::ranges::any_of(faults.lines, [&](const LineFault& fault) {
    return fault.way == LineWay::ToFlight && (fault.replayed > 0 || fault.delay_s > kLateSecs) &&
           now_s >= fault.when.from_s && now_s < fault.when.to_s + kOldReading;
  });
}

}  // namespace

/// Old frames may make guard 6 climb; some time after that it must follow again.
bool CommandJudge::isExcused(const CycleView& view) {
  const bool climbs = view.hookbeh->guard == hooks::HookGuard::DepthsDisagree;
  const bool was = view.time_s - excused_s_ < kExcused;
  if (climbs && (was || oldFramesReachFlight(s_.faults, view.time_s))) {
    excused_s_ = view.time_s;
  }
  return view.time_s - excused_s_ < kExcused;
}

std::string CommandJudge::cycle(const CycleView& view) {
  echo_.cycle(view);
  if (view.hookbeh == nullptr) {
    return "";
  }
  if (view.hook != HookState::Active) {
    restart();
    excused_s_ = kLongAgo;
    return view.hookbeh->commanding ? "hookbeh commands, and the SBC is not in control" : "";
  }
  const double reading = view.array.get(Sensor::m_depth);
  std::string wrong = judgeWhole(view);
  wrong = wrong.empty() ? judgeLimits(view, reading) : wrong;
  wrong = wrong.empty() ? judgeBlind(view, reading) : wrong;
  overridden_s_ = view.overridden() ? view.time_s : overridden_s_;
  const bool excused = isExcused(view);
  if (wrong.empty() && s_.promiseAt(view.time_s).follows && !excused) {
    wrong = judgeGuard(view);
    // Just before the guard's climb, and in its last cycle, noise decides whether a limit is
    // reached.
    if (wrong.empty() && !guarding_) {
      carried_off_ = carried_off_ || view.overridden();
      wrong = judgeFollowing(view, reading);
    }
  }
  return wrong;
}

}  // namespace glider::slocum::oracles
