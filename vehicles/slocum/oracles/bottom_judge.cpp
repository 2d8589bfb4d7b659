// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/bottom_judge.h"

#include "vehicles/slocum/oracles/judge_limits.h"
#include "vehicles/slocum/oracles/wrong_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::slocum::oracles {

using hooks::HookState;

namespace {

// The distance that the pump needs to reverse a steep dive, over a bottom that may rise meanwhile.
constexpr double kClearanceTolerance = 4;  // m
constexpr double kRounding = 1e-6;         // s
constexpr double kOursSecs = 60;           // s after hookbeh's last command
constexpr double kUnderWater = 1;          // m
constexpr double kLeft = 1;                // m: a contact is over
constexpr double kDepthRight = 2;          // m
constexpr double kSlides = 100;  // m along the bottom: the contact is of another place too

bool knowsDepth(const CycleView& view) {
  return std::fabs(view.array.get(Sensor::m_depth) - view.true_depth_m) < kDepthRight;
}

}  // namespace

bool BottomJudge::hearsSeldom() const {
  return s_.echo_every_s > limits::kRareEchoSecs;
}

/// True if the altimeter receives echoes often enough to keep the vehicle off the bottom.
bool BottomJudge::hears(double now_s) const {
  return s_.echo_every_s <= limits::kEchoEverySecs + kRounding && s_.args.least_altitude_m >= 0 &&
         (!hearsSeldom() || echoes_ >= limits::kEchoesToKnow) &&
         !isWrong(s_.faults, {"m_altitude"}, now_s, limits::kEchoFadesSecs);
}

/// True if no contact is allowed. Rare echoes are enough for hookbeh only, since the vehicle's own
/// behaviours remember none; it needs the depth for that, and forgets so shallow a bottom.
bool BottomJudge::mustKnow(const CycleView& view) const {
  const bool ours = view.hook == HookState::Active || inactive_s_ < kOursSecs;
  const bool shallow =
      limits::isShallow(view.true_depth_m + view.clearance_m, s_.args.least_altitude_m);
  const bool silent = silent_s_ > limits::kSilentGaps * s_.echo_every_s ||
                      view.time_s - echo_s_ > limits::kEchoLastsSecs;
  const bool remembers = ours && !shallow && !silent && knowsDepth(view);
  return hears(view.time_s) && (!hearsSeldom() || remembers);
}

void BottomJudge::countEcho(const CycleView& view) {
  constexpr double kRight = 3, kListens = 3;  // m
  const double altitude = view.array.get(Sensor::m_altitude);
  // The sensor array keeps an altitude until there is a newer one.
  const bool echo = view.array.fresh(Sensor::m_altitude) && altitude != altitude_m_ &&
                    std::fabs(altitude - view.clearance_m) < kRight;
  altitude_m_ = altitude;
  echoes_ += echo;
  silent_s_ += view.true_depth_m > kListens && last_s_ < view.time_s ? view.time_s - last_s_ : 0;
  silent_s_ = echo ? 0 : silent_s_;
  echo_s_ = echo ? view.time_s : echo_s_;
}

/// What is wrong with a contact there, after the earlier ones.
std::string BottomJudge::judgePlace(const Place& here) const {
  int short_ones = 0;
  for (const Place& place : places_) {
    const double apart_m = std::hypot(place.east_m - here.east_m, place.north_m - here.north_m);
    const bool shallow = limits::isShallow(place.water_m, s_.args.least_altitude_m);
    const bool forgotten = shallow && here.at_s - place.at_s >= limits::kShallowSecs;
    if (forgotten || apart_m >= limits::kPlaceM || here.water_m <= place.water_m - limits::kRiseM) {
      continue;
    }
    if (place.lasts_s >= limits::kNoticedSecs) {
      return fmt::format("the vehicle is on the bottom again, {:.0f} m from an earlier contact",
                         apart_m);
    }
    short_ones += shallow ? 0 : 1;
  }
  return short_ones < limits::kShortTouches
             ? ""
             : fmt::format("the vehicle has touched the bottom {} times here", short_ones + 1);
}

std::string BottomJudge::judgeNewContact(const CycleView& view) {
  if (mustKnow(view)) {
    return "the vehicle is on the bottom";
  }
  const Place here{view.east_m, view.north_m, view.true_depth_m + view.clearance_m, view.time_s};
  return knowsDepth(view) && view.hook == HookState::Active ? judgePlace(here) : "";
}

std::string BottomJudge::judgeTouch(const CycleView& view, bool was_dark) {
  const bool touches = view.clearance_m < limits::kTouchM && view.true_depth_m > kUnderWater;
  const bool began = touches && !touching_;
  touching_ = touches || (touching_ && view.clearance_m < kLeft && view.true_depth_m > kUnderWater);
  met_in_dark_ = touching_ && (met_in_dark_ || (began && was_dark));
  if (!touches) {
    return "";
  }
  if (began) {
    touched_s_ = view.time_s;
    if (std::string wrong = met_in_dark_ ? "" : judgeNewContact(view); !wrong.empty()) {
      return wrong;
    }
  }
  const Place here{view.east_m, view.north_m, view.true_depth_m + view.clearance_m, view.time_s};
  // A hookbeh that begins on the bottom knows no place either: restart().
  if (began || places_.empty() ||
      std::hypot(places_.back().east_m - here.east_m, places_.back().north_m - here.north_m) >
          kSlides) {
    places_.push_back(here);
  }
  const double lasts_s = view.time_s - touched_s_;
  places_.back().lasts_s = lasts_s;
  return lasts_s > limits::kOnBottomSecs
             ? fmt::format("the vehicle has been on the bottom for {:.0f} s", lasts_s)
             : "";
}

std::string BottomJudge::judgeClearance(const CycleView& view, bool active) {
  const double lacking = std::max(0.0, s_.args.least_altitude_m - view.clearance_m);
  if (!active) {
    inactive_s_ += std::isnan(last_s_) ? 0 : view.time_s - last_s_;
    return "";
  }
  // After a time in which the vehicle could climb, it may be low through another behaviour. A
  // shorter one does not excuse what hookbeh did before it.
  const bool afresh = inactive_s_ >= s_.turn_s;
  const double most = afresh ? lacking : std::min(allowed_m_, lacking);
  allowed_m_ =
      std::max(kClearanceTolerance, afresh ? most + kClearanceTolerance
                                           : std::min(allowed_m_, lacking + kClearanceTolerance));
  inactive_s_ = 0;
  // Between rare echoes a dive goes on over a bottom that may have risen: only contacts are
  // checked.
  const bool judged = s_.promiseAt(view.time_s).clearance && hears(view.time_s) && !hearsSeldom();
  return judged && lacking > allowed_m_
             ? fmt::format("{:.1f} m over the bottom under min_altitude {} m", view.clearance_m,
                           s_.args.least_altitude_m)
             : "";
}

std::string BottomJudge::cycle(const CycleView& view) {
  const bool was_dark = s_.isDark(view.time_s - last_s_);
  countEcho(view);
  std::string touch = judgeTouch(view, was_dark);
  std::string clearance = judgeClearance(view, view.hook == HookState::Active);
  last_s_ = view.time_s;
  return touch.empty() ? clearance : touch;
}

}  // namespace glider::slocum::oracles
