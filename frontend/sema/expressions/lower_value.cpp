// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/values.h"
#include "support/diagnostics/ids/meaning.h"

#include <array>

// Names with a meaning unless the mission uses them itself: `here`, `utc`, `timeofday`, `salinity`,
// `density`, `energyused`, `energyleft`, `nearest`, `usual_pitch`, `usual_speed`, `turned`, and the
// states of a sensor, such as `diving`.

namespace glider::frontend {
namespace {

constexpr double kDay_s = 86400;

}  // namespace

bool meansValue(std::string_view name, const support::SourceRange& where, Scope& scope) {
  return (isValueName(name) || findSensorState(scope.platform(), name)) &&
         !scope.declares(name, where) && scope.platform().find(name) == nullptr;
}

ExprLowering::Result ExprLowering::meantValue(const std::string& name,
                                              const support::SourceRange& range) {
  if (const auto state = findSensorState(scope_.platform(), name)) {
    return inState(*state, range);
  }
  if (name == "here") {
    const Result place = here(range);
    return place ? Result(wholePlace(*place, range)) : std::nullopt;
  }
  if (name == "utc") {
    return utc(range);
  }
  if (name == "timeofday") {
    const Result now = utc(range);
    const auto time = quantity(support::dimension::time);
    return now ? Result(emit(ir::Op::Remainder, time, range,
                             {now->id, emitNumber(kDay_s, time, range).id}))
               : std::nullopt;
  }
  if (name == "turned") {
    return turned(range);
  }
  if (name == "energyused" || name == "energyleft") {
    return energyValue(name, range);
  }
  if (name == "nearest") {
    return nearest(range);
  }
  if (name == "usual_pitch" || name == "usual_speed") {
    return usualSlope(name == "usual_speed", range);
  }
  if (name == "yo_number") {
    return yoNumber(range);
  }
  return ofWater(name == "salinity" ? ir::Op::Salinity : ir::Op::Density, range);
}

/// What a command to go to a depth also says, if that is what the vehicle takes.
ExprLowering::Result ExprLowering::usualSlope(bool speed, const support::SourceRange& range) {
  const platforms::Envelope& envelope = scope_.platform().envelope;
  if (envelope.steersBySpeed() != speed) {
    scope_.report(support::diagnostics::otherSlope, range, scope_.platform().name,
                  speed ? "goes to a depth at a pitch, not at a speed"
                        : "goes to a depth at a speed, not at a pitch",
                  speed ? "usual_speed" : "usual_pitch",
                  speed ? "write `usual_pitch`" : "write `usual_speed`");
    return std::nullopt;
  }
  return speed ? emitNumber(envelope.usual_speed_m_s, quantity(support::dimension::speed), range)
               : emitNumber(envelope.usual_pitch_rad, quantity(support::dimension::angle), range);
}

ExprLowering::Result ExprLowering::inState(const SensorState& state,
                                           const support::SourceRange& range) {
  const Value value = *sensor(*state.sensor, state.sensor->name, range);
  reads_.back().implied = true;
  return emit(ir::Op::Equal, boolean(), range,
              {value.id, emitNumber(state.value, value.type, range).id});
}

ExprLowering::Result ExprLowering::utc(const support::SourceRange& range) {
  const platforms::PlatformSensor* clock = findTimestamp(scope_.platform());
  if (clock == nullptr) {
    scope_.report(support::diagnostics::unknownSensor, range, scope_.platform().name, "utc",
                  "the vehicle reports no time of the calendar");
    return std::nullopt;
  }
  const Result time = sensor(*clock, clock->name, range);
  reads_.back().implied = true;
  return time;
}

/// `became(diving) || became(climbing)`
ExprLowering::Result ExprLowering::turned(const support::SourceRange& range) {
  const auto began = [&](const char* state) {
    const ast::Expr name{ast::NameUse{state}, range};
    const ast::Expr became{ast::Invocation{{"became", range}, {{name, {}, {}}}}, range};
    return lower(became, std::nullopt);
  };
  for (const char* state : {"diving", "climbing"}) {
    if (!meansValue(state, range, scope_)) {
      scope_.report(support::diagnostics::unknownSensor, range, scope_.platform().name, "turned",
                    scope_.declares(state, range)
                        ? std::string("the mission uses the name `") + state + "` itself"
                        : "the vehicle does not report whether it dives or climbs");
      return std::nullopt;
    }
  }
  const Result dives = began("diving");
  const Result climbs = began("climbing");
  return dives && climbs ? Result(emit(ir::Op::Or, boolean(), range, {dives->id, climbs->id}))
                         : std::nullopt;
}

/// `energyused` and `energyleft`, by the vehicle's count of its charge and the line `pack`.
ExprLowering::Result ExprLowering::energyValue(const std::string& name,
                                               const support::SourceRange& range) {
  const platforms::PlatformSensor* counter = findCharge(scope_.platform());
  if (counter == nullptr) {
    scope_.report(support::diagnostics::unknownSensor, range, scope_.platform().name, name,
                  "the vehicle does not count the charge that it uses");
    return std::nullopt;
  }
  if (!scope_.context.constant.empty()) {
    scope_.report(support::diagnostics::notConstant, range, name, scope_.context.constant);
    return std::nullopt;
  }
  if (scope_.context.at_start) {
    scope_.report(support::diagnostics::notAtStart, range, name);
    return std::nullopt;
  }
  if (!scope_.energy) {
    scope_.report(support::diagnostics::packMissing, range, name);
    scope_.energy.emplace();  // once is enough
    return std::nullopt;
  }
  if (!scope_.energy->good) {
    return std::nullopt;
  }
  const ir::Pack& pack = scope_.energy->pack;
  const auto charge = quantity(support::dimension::charge);
  const Value used = *sensor(*counter, counter->alias, range);
  reads_.back().implied = true;
  if (name == "energyleft") {
    const Value share = emit(ir::Op::Divide, plainNumber(), range,
                             {used.id, emitNumber(pack.capacity_C, charge, range).id});
    Value left = emit(ir::Op::Subtract, plainNumber(), range,
                      {emitNumber(1, plainNumber(), range).id, share.id});
    left.scale = {"%", false};
    left.charge = used.id;
    return left;
  }
  const ir::ExprId first = ir::MissionWriter(scope_.mission, range).read(scope_.energy->start);
  const Value since = emit(ir::Op::Subtract, charge, range, {used.id, first});
  const auto voltage = emitNumber(pack.voltage_V, quantity(support::dimension::voltage), range);
  return emit(ir::Op::Multiply, quantity(support::dimension::energy), range,
              {since.id, voltage.id});
}

ExprLowering::Result ExprLowering::ofWater(ir::Op op, const support::SourceRange& range) {
  std::array<ir::ExprId, 3> measured;
  constexpr std::array<const char*, 3> kCtd = {"cond", "temp", "scipressure"};
  for (size_t i = 0; i < kCtd.size(); ++i) {
    const platforms::PlatformSensor* found = scope_.platform().find(kCtd.at(i));
    if (found == nullptr) {
      scope_.report(support::diagnostics::unknownSensor, range, scope_.platform().name, kCtd.at(i),
                    "salinity and density need conductivity, temperature and pressure of a CTD");
      return std::nullopt;
    }
    measured.at(i) = sensor(*found, kCtd.at(i), range)->id;
  }
  Value result = emitOf(op, range, measured);
  result.scale = {"1", false};
  return result;
}

}  // namespace glider::frontend
