// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/world.h"

namespace glider::ir::prove {
namespace {

z3::expr smaller(const z3::expr& a, const z3::expr& b) {
  return z3::ite(a <= b, a, b);
}

z3::expr larger(const z3::expr& a, const z3::expr& b) {
  return z3::ite(a >= b, a, b);
}

/// Towards a depth: the vehicle does not go deeper, except for an overshoot.
Vehicle downTo(const Vehicle& before, const z3::expr& target, const z3::expr& overshoot) {
  Vehicle after = before;
  after.deepest = larger(target + overshoot, smaller(before.deepest, before.depth + overshoot));
  after.climbing = before.climbing.ctx().bool_val(false);
  return after;
}

/// Up to a depth: there, or from above it, the vehicle hovers at it.
Vehicle upTo(const Vehicle& before, const z3::expr& target, const z3::expr& overshoot,
             const z3::expr& now) {
  Vehicle after = before;
  const z3::expr hovers = target >= realOf(target.ctx(), kFloats);
  after.top = z3::ite(hovers, target + overshoot, target);
  const z3::expr goes_on = before.climbing && after.top >= before.top;
  const z3::expr turned =
      z3::ite(goes_on, before.deepest, smaller(before.deepest, before.depth + overshoot));
  after.deepest = z3::ite(hovers, larger(after.top, turned), turned);
  after.since = z3::ite(goes_on, before.since, now);
  after.climbing = before.climbing.ctx().bool_val(true);
  return after;
}

}  // namespace

Vehicle obey(const Vehicle& before, Command command, const std::vector<NumberTerm>& arguments,
             const z3::expr& now, const z3::expr& allowed, const platforms::Platform& platform,
             Unknowns& unknowns) {
  z3::context& context = unknowns.context();
  const z3::expr overshoot = realOf(context, platform.envelope.inflection_overshoot_m);
  Vehicle after = before;
  switch (command) {
    case Command::Descend:
    case Command::Hover:
      after = downTo(before, arguments.at(0).value, overshoot);
      break;
    case Command::Ascend:
      after = upTo(before, arguments.at(0).value, overshoot, now);
      break;
    case Command::Surface:
      after = upTo(before, context.real_val(0), overshoot, now);
      break;
    case Command::Steer:
    case Command::SteerTo:
    case Command::Drift:
      return before;
  }
  Store yes;
  yes.vehicle = after;
  Store no;
  no.vehicle = before;
  return *choose(allowed, yes, no).vehicle;
}

Vehicle obeyAnything(const Vehicle& before, Unknowns& unknowns) {
  Vehicle after = before;
  after.deepest = unknowns.real("deepest");
  after.climbing = unknowns.truth("climbing");
  after.since = unknowns.real("since");
  after.top = unknowns.real("top");
  unknowns.require(after.deepest >= before.depth);
  return after;
}

z3::expr moves(const Vehicle& before, const z3::expr& from, const z3::expr& to,
               const z3::expr& depth, const platforms::Platform& platform) {
  z3::context& context = from.ctx();
  const auto real = [&](double value) { return realOf(context, value); };
  const z3::expr way = real(platform.envelope.vertical_rate_m_s) * (to - from);
  const z3::expr climbs = to - before.since - real(platform.world.turn_s);
  const z3::expr lifted = before.deepest - real(platform.world.slowest_climb_m_s) * climbs;
  return depth >= 0 && depth <= before.deepest && depth <= before.depth + way &&
         depth >= before.depth - way &&
         z3::implies(before.climbing && climbs >= 0,
                     depth <= larger(larger(before.top, context.real_val(0)), lifted));
}

z3::expr begins(const Vehicle& vehicle, const platforms::Platform& platform) {
  z3::context& context = vehicle.depth.ctx();
  const auto real = [&](double value) { return realOf(context, value); };
  return vehicle.depth >= 0 && vehicle.depth <= real(platform.world.start_depth_m) &&
         vehicle.deepest == vehicle.depth + real(platform.envelope.inflection_overshoot_m) &&
         !vehicle.climbing && vehicle.since == 0 && vehicle.top == 0;
}

}  // namespace glider::ir::prove
