// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/disc_of_distance.h"

#include "frontend/sema/expressions/evaluate.h"

#include <cmath>

namespace glider::frontend {
namespace {

/// No place on the mission's sphere is farther from another, m: a condition with this radius, or a
/// greater one, is decided, and no disc.
constexpr double kFarthest = 20015000;

/// Whether two expressions are the position of the vehicle.
bool isHere(ir::ExprId north, ir::ExprId east, Scope& scope) {
  const auto reads = [&](ir::ExprId id, const char* name) {
    const ir::Expr& e = scope.mission[id];
    const platforms::PlatformSensor* row = scope.platform().find(name);
    return e.op == ir::Op::Sensor && row != nullptr &&
           scope.mission[e.sensor].vehicle_name == row->name;
  };
  return reads(north, "lat") && reads(east, "lon");
}

std::optional<ir::Position> placeOf(ir::ExprId north, ir::ExprId east, const ir::Mission& m) {
  const auto latitude = evaluate(m, north);
  const auto longitude = evaluate(m, east);
  if (!latitude || !longitude || !(std::fabs(*latitude) <= 90)) {
    return std::nullopt;
  }
  const double turned = std::remainder(*longitude, 360);
  return std::isnan(turned) ? std::nullopt : std::optional(ir::Position{*latitude, turned});
}

/// The place to which an expression is the vehicle's distance.
std::optional<ir::Position> fromHere(ir::ExprId id, Scope& scope) {
  const ir::Expr& e = scope.mission[id];
  if (e.op != ir::Op::Distance) {
    return std::nullopt;
  }
  const auto& ends = e.operands;  // two latitudes, each with its longitude
  if (isHere(ends[0], ends[1], scope)) {
    return placeOf(ends[2], ends[3], scope.mission);
  }
  return isHere(ends[2], ends[3], scope) ? placeOf(ends[0], ends[1], scope.mission) : std::nullopt;
}

}  // namespace

std::optional<ir::Geofence> discOf(ir::ExprId id, bool wanted, Scope& scope) {
  const ir::Expr& e = scope.mission[id];
  const bool less = e.op == ir::Op::Less || e.op == ir::Op::LessEqual;
  if (!less && e.op != ir::Op::Greater && e.op != ir::Op::GreaterEqual) {
    return std::nullopt;
  }
  auto centre = fromHere(e.operands[0], scope);
  const bool distance_first = centre.has_value();
  if (!distance_first) {
    centre = fromHere(e.operands[1], scope);
  }
  const auto radius = evaluate(scope.mission, e.operands[distance_first ? 1 : 0]);
  if (!centre || !radius || !(*radius > 0 && *radius < kFarthest)) {
    return std::nullopt;
  }
  const bool closer = less == distance_first;
  return ir::Geofence{closer == wanted, {*centre}, *radius};
}

}  // namespace glider::frontend
