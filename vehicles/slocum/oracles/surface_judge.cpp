// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/surface_judge.h"

#include "vehicles/slocum/oracles/judge_limits.h"
#include "vehicles/slocum/oracles/wrong_sensors.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::slocum::oracles {

using hooks::HookState;
using hooks::HookVertical;

namespace {

constexpr double kAtSurface = 2;   // m
constexpr double kLeastDepth = 2;  // m: a target above this is the surface
constexpr double kDepthError = 2;  // m
constexpr double kLeastShare = 0.5;
constexpr double kEchoError = 2;    // m, and
constexpr double kEchoShare = 0.1;  // of the clearance

bool near(double reading, double truth, double error) {
  return std::fabs(reading - truth) <= error;
}

}  // namespace

bool readingsAreRight(const CycleView& view) {
  const bool depth = near(view.array.get(Sensor::m_depth), view.true_depth_m, kDepthError);
  const double ctd_m = ctdDepth(view);
  const bool ctd = std::isnan(ctd_m) || near(ctd_m, view.true_depth_m, kDepthError);
  const double altitude = view.array.get(Sensor::m_altitude);
  const bool echo = !view.array.fresh(Sensor::m_altitude) || !(altitude >= 0) ||
                    near(altitude, view.clearance_m, kEchoError + kEchoShare * view.clearance_m);
  return depth && ctd && echo;
}

bool SurfaceJudge::shouldDive(const CycleView& view, const hooks::Instruction& in_force) const {
  const bool commanded =
      (in_force.vertical == HookVertical::Descend || in_force.vertical == HookVertical::Hover) &&
      in_force.depth_m > kLeastDepth;
  const double water_m = view.clearance_m + view.true_depth_m;
  // Between rare echoes the bottom may rise to half of its depth.
  const double least_m = s_.echo_every_s > limits::kRareEchoSecs ? kLeastShare * water_m : water_m;
  // Over a bottom that it has touched in shallower water it waits for half an hour.
  const bool room = !limits::isShallow(least_m - kDepthError, s_.args.least_altitude_m);
  return ours_s_ > limits::kTakesHoldSecs && commanded && room && !trust_.isLost() &&
         right_s_ > limits::kRightSecs;
}

std::string SurfaceJudge::cycle(const CycleView& view, const hooks::Instruction& in_force) {
  const double step_s = s_.isDark(view.time_s - last_s_) ? 0 : view.time_s - last_s_;
  last_s_ = view.time_s;
  // A depth that is stuck at zero is right there by chance.
  const bool right =
      readingsAreRight(view) && !isWrong(s_.faults, {"m_depth", "m_pressure"}, view.time_s, 0);
  right_s_ = right ? right_s_ + step_s : 0;
  const bool ours = view.hook == HookState::Active && !view.overridden();
  ours_s_ = ours ? ours_s_ + step_s : 0;
  trust_.cycle(view, step_s);
  const bool wanted = shouldDive(view, in_force);
  const bool is_up = wanted && view.true_depth_m < kAtSurface;
  stays_s_ = is_up ? stays_s_ + step_s : 0;
  wanted_s_ += wanted ? step_s : 0;
  surface_s_ += is_up ? step_s : 0;
  if (stays_s_ > limits::kAtSurfaceSecs) {
    return fmt::format("at the surface for {:.0f} s though {} m is commanded", stays_s_,
                       in_force.depth_m);
  }
  return wanted_s_ > limits::kLongSecs && surface_s_ > limits::kSurfaceShare * wanted_s_
             ? fmt::format(
                   "at the surface for {:.0f} of the {:.0f} s in which a depth was commanded",
                   surface_s_, wanted_s_)
             : "";
}

}  // namespace glider::slocum::oracles
