// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/lower_declination.h"

#include "frontend/sema/declarations/declared_value.h"
#include "frontend/sema/declarations/only_item.h"
#include "support/diagnostics/ids/meaning.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace glider::frontend {

namespace {

/// The angle, rad; empty, and reported, if it is not an angle or exceeds half a turn.
std::optional<double> angleOf(const ast::Declination& node, Scope& scope) {
  const DeclaredType angle{quantity(support::dimension::angle)};
  const ast::Name role{"declination", node.where};
  const auto known =
      DeclaredValue(role, angle, scope).constant(node.angle, "the angle of `declination`");
  if (known && std::fabs(known->first) > std::numbers::pi) {
    scope.report(support::diagnostics::declinationRange, node.angle.where,
                 "`" + scope.text(node.angle.where) + "`");
    return std::nullopt;
  }
  return known ? std::optional(known->first) : std::nullopt;
}

/// Whether the mission reads or commands headings. What a route in C commands is not known.
bool hasHeadings(const ir::Mission& mission) {
  const auto steers = [](const ir::Statement& statement) {
    return statement.kind == ir::StatementKind::Command && statement.command == ir::Command::Steer;
  };
  return std::ranges::any_of(
             mission.sensors,
             [](const ir::Sensor& s) { return s.encoding == ir::Encoding::Magnetic; }) ||
         std::ranges::any_of(
             mission.blocks,
             [&](const ir::Block& b) { return std::ranges::any_of(b.statements, steers); }) ||
         std::ranges::any_of(mission.behaviours, [](const ir::Behaviour& b) {
           return b.kind == ir::BehaviourKind::Route && !b.symbol.empty();
         });
}

/// A vehicle that is not steered through its sensor array, and reports headings from true north.
bool hasTrueHeadings(const platforms::Platform& platform) {
  return platform.seatIsOnBoard() &&
         std::ranges::none_of(platform.sensors, &platforms::PlatformSensor::magnetic);
}

/// The `mission` line, which a mission without errors has.
support::SourceRange headOf(const ast::File& file) {
  for (const ast::Item& item : file.items) {
    if (const auto* line = std::get_if<ast::MissionLine>(&item)) {
      return line->where;
    }
  }
  return {file.file, 0, 0};
}

}  // namespace

void lowerDeclination(const ast::File& file, Scope& scope) {
  const auto* line = onlyItem<ast::Declination>(file, [&](const auto& again, const auto& first) {
    scope.report(support::diagnostics::declinationTwice, again.where)
        .note(first.where, "the first is here");
  });
  if (line != nullptr) {
    scope.declination = angleOf(*line, scope);
  }
}

void lowerCompass(const ast::File& file, Scope& scope) {
  ir::Compass compass;
  compass.declination = scope.declination;
  if (!hasHeadings(scope.mission) || hasTrueHeadings(scope.platform())) {
    return;
  }
  const platforms::PlatformSensor* variation = scope.platform().find(platforms::kVariationSensor);
  if (variation != nullptr) {
    compass.variation = scope.subscribe(*variation, variation->name);
  } else if (!scope.declination) {
    scope.report(support::diagnostics::declinationUnknown, headOf(file));
  }
  scope.mission.compass = compass;
}

}  // namespace glider::frontend
