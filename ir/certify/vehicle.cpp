// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/certify/vehicle.h"

#include "support/check.h"

#include <utility>

namespace glider::ir::certify {
namespace {

/// Commands to climb to less than this depth mean the surface, m.
constexpr double kSurface = 1;

Term greater(SmtText& out, const Term& a, const Term& b) {
  return out.real(choice(operation(">=", {a, b}), a, b));
}

Term smaller(SmtText& out, const Term& a, const Term& b) {
  return out.real(choice(operation("<=", {a, b}), a, b));
}

/// The time in which the vehicle obeys a command: it crosses the line, after it may have waited as
/// long for one before.
double lateBy(const Setting& setting) {
  const platforms::EnvironmentModel& world = setting.platform.world;
  const double crossing = world.line_lag_s + setting.platform.envelope.cycle_s;
  return crossing + crossing + world.command_delay_s;
}

/// Where a dive that is ended now may still get: the command needs its time, and the vehicle sinks
/// on.
Term endOfDive(const Setting& setting, SmtText& out, const Vehicle& v) {
  const platforms::Envelope& envelope = setting.platform.envelope;
  const double beyond =
      envelope.vertical_rate_m_s * lateBy(setting) + envelope.inflection_overshoot_m;
  return smaller(out, v.deepest, operation("+", {v.depth, literal(beyond)}));
}

/// V3.
Vehicle descended(const Setting& setting, SmtText& out, const Vehicle& before, const Term& x) {
  const Term overshoot = literal(setting.platform.envelope.inflection_overshoot_m);
  Vehicle after = before;
  after.deepest =
      greater(out, out.real(operation("+", {x, overshoot})), endOfDive(setting, out, before));
  after.climbing = "false";
  return after;
}

/// V4.
Vehicle ascended(const Setting& setting, SmtText& out, const Vehicle& before, const Term& x,
                 const Term& now) {
  const double below =
      setting.platform.envelope.inflection_overshoot_m + setting.platform.world.climb_hold_m;
  const Term dives = out.boolean(operation(">=", {x, literal(kSurface)}));
  Vehicle after = before;
  after.top = out.real(choice(dives, operation("+", {x, literal(below)}), x));
  // By the port a climb to elsewhere that is not obeyed yet may never be, and each depth crosses by
  // itself: what follows a surfacing may begin with a dive.
  const Term old = operation(">=", {now, operation("+", {before.since, literal(lateBy(setting))})});
  const Term dived = operation(">=", {before.top, literal(kSurface)});
  const Term obeyed =
      setting.platform.world.command_delay_s > 0
          ? disjunction({operation("=", {after.top, before.top}), conjunction({old, dived})})
          : Term("true");
  const Term on =
      out.boolean(conjunction({before.climbing, operation(">=", {after.top, before.top}), obeyed}));
  const Term end = out.real(choice(on, before.deepest, endOfDive(setting, out, before)));
  after.deepest = out.real(choice(dives, greater(out, after.top, end), end));
  after.since = out.real(choice(on, before.since, now));
  after.climbing = "true";
  return after;
}

Vehicle whereKnown(SmtText& out, const Term& known, const Vehicle& after, const Vehicle& before) {
  const auto real = [&](const Term& a, const Term& b) { return out.real(choice(known, a, b)); };
  return {before.depth, real(after.deepest, before.deepest),
          out.boolean(choice(known, after.climbing, before.climbing)),
          real(after.since, before.since), real(after.top, before.top)};
}

}  // namespace

Vehicle vehicleAtStart(const Setting& setting, SmtText& out) {
  Vehicle v;
  v.depth = out.fresh("Real");
  out.require(operation("<=", {"0.0", v.depth, literal(setting.platform.world.start_depth_m)}));
  v.deepest = out.real(
      operation("+", {v.depth, literal(setting.platform.envelope.inflection_overshoot_m)}));
  return v;
}

Vehicle vehicleLater(const Setting& setting, SmtText& out, const Vehicle& before, const Term& from,
                     const Term& to) {
  const platforms::EnvironmentModel& world = setting.platform.world;
  Vehicle after = before;
  after.depth = out.fresh("Real");
  const Term way = out.real(operation(
      "*", {literal(setting.platform.envelope.vertical_rate_m_s), operation("-", {to, from})}));
  out.require(operation("<=", {"0.0", after.depth, before.deepest}));
  out.require(operation("<=", {operation("-", {before.depth, way}), after.depth,
                               operation("+", {before.depth, way})}));
  const Term climbed =
      out.real(operation("-", {to, before.since, literal(world.command_delay_s + world.turn_s)}));
  const Term reached =
      operation("-", {before.deepest, operation("*", {literal(world.slowest_climb_m_s), climbed})});
  out.require(implication(conjunction({before.climbing, operation(">=", {climbed, "0.0"})}),
                          disjunction({operation("<=", {after.depth, before.top}),
                                       operation("<=", {after.depth, "0.0"}),
                                       operation("<=", {after.depth, reached})})));
  return after;
}

Vehicle commanded(const Setting& setting, SmtText& out, const Vehicle& before, Command command,
                  std::span<const Number> arguments, const Term& now) {
  std::vector<Term> known;
  for (const Number& argument : arguments) {
    known.push_back(argument.known);
  }
  const Term all = out.boolean(conjunction(known));
  switch (command) {
    case Command::Descend:
    case Command::DescendAt:
    case Command::Hover:
      return whereKnown(out, all, descended(setting, out, before, arguments[0].value), before);
    case Command::Ascend:
    case Command::AscendAt:
      return whereKnown(out, all, ascended(setting, out, before, arguments[0].value, now), before);
    case Command::Surface:
      return ascended(setting, out, before, "0.0", now);
    case Command::Pump:
    case Command::Battery: {  // V8
      const Term limit = literal(setting.platform.envelope.greatest_depth_m);
      return whereKnown(out, all, descended(setting, out, before, limit), before);
    }
    case Command::Steer:
    case Command::SteerTo:
    case Command::Drift:
    case Command::Fin:
      return before;
  }
  CHECK(false, "a command without a meaning");
  std::unreachable();
}

Vehicle commandedInC(SmtText& out, const Vehicle& before) {
  const Vehicle after{before.depth, out.fresh("Real"), out.fresh("Bool"), out.fresh("Real"),
                      out.fresh("Real")};
  out.require(operation(">=", {after.deepest, before.depth}));
  return after;
}

}  // namespace glider::ir::certify
