// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <algorithm>
#include <optional>
#include <utility>

/// The rules V1 to V5 and V8 of the vehicle (docs/verification.md, "The rules of the vehicle"),
/// once for questions and flights: a template over an algebra of numbers and truths.
///
/// An Algebra has `number(double)`, `truth(bool)` and `choose(truth, a, b)`; its numbers and truths
/// have the operators of C++. Terms of Z3 are one (encoding/world.cpp), doubles another
/// (falsification/depth_limits.cpp). A Vehicle has five values: its true `depth` (m); `deepest`,
/// the deepest that the command in force allows (m); `climbing`, whether that command leads up;
/// `since`, the mission time of the first command to climb that has been in force since (s); `top`,
/// at which a climb may stop (m).
///
/// ir/certify/vehicle.h and analysis/certificates/run_vehicle.h have the rules a second time, on
/// purpose: they check what is proved here.
namespace glider::ir::prove {

/// A command to climb to a depth above this (m) ends at the surface: hookbeh does not hover there.
inline constexpr double kFloats = 1;

/// V2: from this time (s) after the command to climb on, a vehicle that was no deeper than `from`
/// (m) is no deeper than `to`; rounded up.
inline double longestClimb(const platforms::EnvironmentModel& world, double from, double to) {
  constexpr double kRoundedUp = 1 + 0x1p-40;
  const double way = std::max(0.0, from - to);
  return (world.command_delay_s + world.turn_s + way / world.slowest_climb_m_s) * kRoundedUp;
}

template <typename Algebra>
class VehicleRules {
 public:
  /// Both outlive this.
  VehicleRules(const Algebra& algebra, const platforms::Platform& platform)
      : algebra_(algebra),
        platform_(platform),
        overshoot_(algebra.number(platform.envelope.inflection_overshoot_m)),
        late_s_(2 * (platform.world.line_lag_s + platform.envelope.cycle_s) +
                platform.world.command_delay_s),
        late_overshoot_(algebra.number(platform.envelope.vertical_rate_m_s * late_s_ +
                                       platform.envelope.inflection_overshoot_m)) {}

  /// V1: the deepest of a vehicle that begins at `depth`.
  template <typename Number>
  [[nodiscard]] Number deepestAtStart(const Number& depth) const {
    return depth + overshoot_;
  }

  /// V2: tells `limits` what limits the depth when mission time has gone from `from` to `to`, by
  /// atLeast(depth), atMost(depth) and atMostIf(truth, depth).
  template <typename Vehicle, typename Number, typename Limits>
  void move(const Vehicle& before, const Number& from, const Number& to, Limits& limits) const {
    const Number way = number(platform_.envelope.vertical_rate_m_s) * (to - from);
    const Number climbs =
        to - before.since - number(platform_.world.command_delay_s + platform_.world.turn_s);
    const Number lifted = before.deepest - number(platform_.world.slowest_climb_m_s) * climbs;
    limits.atLeast(number(0));
    limits.atMost(before.deepest);
    limits.atMost(before.depth + way);
    limits.atLeast(before.depth - way);
    limits.atMostIf(before.climbing && climbs >= number(0),
                    larger(larger(before.top, number(0)), lifted));
  }

  /// V3 to V5 and V8: after `command` at mission time `now`, all of whose arguments are known;
  /// `target()` is the first of them. None: the command changes nothing.
  template <typename Vehicle, typename Number, typename Target>
  [[nodiscard]] std::optional<Vehicle> obey(const Vehicle& before, Command command,
                                            const Target& target, const Number& now) const {
    switch (command) {
      case Command::Descend:
      case Command::DescendAt:
      case Command::Hover:
        return downTo(before, target());
      case Command::Ascend:
      case Command::AscendAt:
        return upTo(before, target(), now);
      case Command::Surface:
        return upTo(before, number(0), now);
      case Command::Pump:
      case Command::Battery:
        return downTo(before, number(platform_.envelope.greatest_depth_m));  // V8
      case Command::Steer:
      case Command::SteerTo:
      case Command::Drift:
      case Command::Fin:
        break;
    }
    return std::nullopt;  // V5
  }

  /// V3: towards a depth, the vehicle does not go deeper except for an overshoot.
  template <typename Vehicle, typename Number>
  [[nodiscard]] Vehicle downTo(const Vehicle& before, const Number& target) const {
    Vehicle after = before;
    after.deepest = larger(target + overshoot_, endOfDive(before));
    after.climbing = algebra_.truth(false);
    return after;
  }

  /// V4: up to a depth; there, or from above it, the vehicle hovers at it.
  template <typename Vehicle, typename Number>
  [[nodiscard]] Vehicle upTo(const Vehicle& before, const Number& target, const Number& now) const {
    Vehicle after = before;
    const auto hovers = target >= number(kFloats);
    const double hold = platform_.world.climb_hold_m + platform_.envelope.inflection_overshoot_m;
    after.top = algebra_.choose(hovers, target + number(hold), target);
    const auto goes_on = before.climbing && after.top >= before.top && isObeyed(before, after, now);
    const Number turned = algebra_.choose(goes_on, before.deepest, endOfDive(before));
    after.deepest = algebra_.choose(hovers, larger(after.top, turned), turned);
    after.since = algebra_.choose(goes_on, before.since, now);
    after.climbing = algebra_.truth(true);
    return after;
  }

 private:
  [[nodiscard]] auto number(double value) const { return algebra_.number(value); }

  /// Where the dive before may still get: it goes on until the next command is obeyed, and then
  /// while the vehicle turns.
  template <typename Vehicle>
  [[nodiscard]] auto endOfDive(const Vehicle& before) const {
    return smaller(before.deepest, before.depth + late_overshoot_);
  }

  /// Whether the climb of `before` is obeyed at `now`: if not, the command that leads to `after`
  /// takes its place, unless it is the same climb.
  template <typename Vehicle, typename Number>
  [[nodiscard]] auto isObeyed(const Vehicle& before, const Vehicle& after,
                              const Number& now) const {
    // By the port each depth crosses by itself: what follows a surfacing may begin with a dive.
    // After a nap (ir/worlds/naps.h) that is more than is needed: commands then come together, in
    // order.
    const auto dived = before.top >= number(kFloats);
    const auto old = now >= before.since + number(late_s_) && dived;
    return platform_.world.command_delay_s > 0 ? old || after.top == before.top
                                               : algebra_.truth(true);
  }

  template <typename Number>
  [[nodiscard]] Number smaller(const Number& a, const Number& b) const {
    return algebra_.choose(a <= b, a, b);
  }

  template <typename Number>
  [[nodiscard]] Number larger(const Number& a, const Number& b) const {
    return algebra_.choose(a >= b, a, b);
  }

  const Algebra& algebra_;
  const platforms::Platform& platform_;
  decltype(std::declval<const Algebra&>().number(0)) overshoot_;
  /// The time in which a command is obeyed: until it has crossed the vehicle's line and the next
  /// control cycle has come; and so long it may wait before, or another may replace it that is
  /// obeyed in its place (runtime/core/control.h).
  double late_s_;
  /// Of a dive that a command ends: so long it sinks on.
  decltype(std::declval<const Algebra&>().number(0)) late_overshoot_;
};

}  // namespace glider::ir::prove
