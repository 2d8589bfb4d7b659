// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/vehicles.h"

#include "frontend/sema/declarations/only_item.h"
#include "frontend/sema/declarations/share_fit.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {
namespace {

/// Also one that is refused is entered, so that what is received from it is not reported again.
void enterVehicle(const ast::Name& name, Scope& scope) {
  if (std::ranges::find(scope.vehicles, name.text) != scope.vehicles.end()) {
    scope.report(support::diagnostics::vehicleName, name.where, name.text,
                 "another vehicle has this name", "each has a name of its own");
    return;
  }
  if (std::string(name.text) + "." == kPeerPrefix) {
    scope.report(support::diagnostics::vehicleName, name.where, name.text,
                 "`peer` stands for any other vehicle", "choose another name");
  }
  scope.vehicles.push_back(name.text);
}

/// Which share it is, by the name of what any vehicle tells of it.
ir::Share& shareCalled(std::string_view name, ir::Mission& mission) {
  return *std::ranges::find(mission.shares, name, &ir::Share::name);
}

}  // namespace

void lowerVehicles(const ast::File& file, Scope& scope) {
  const auto* line = onlyItem<ast::Vehicles>(file, [&](const auto& again, const auto& first) {
    scope
        .report(support::diagnostics::vehiclesLine, again.where, "appears twice",
                "keep one of the two lines")
        .note(first.where, "the first is here");
  });
  if (line == nullptr) {
    return;
  }
  if (firstShare(file, {}) == nullptr) {
    scope.report(support::diagnostics::vehiclesLine, line->where,
                 "is of no use, as the mission shares nothing",
                 "write for example `share depth in 0 m .. 200 m precision 1 m every 10 min`");
  }
  for (const ast::Name& name : line->names) {
    enterVehicle(name, scope);
  }
  if (scope.vehicles.size() > ir::kMostNamedVehicles) {
    scope.report(support::diagnostics::vehiclesLine, line->names[ir::kMostNamedVehicles].where,
                 fmt::format("has {} names", scope.vehicles.size()),
                 fmt::format("a modem has only {} addresses", ir::kMostNamedVehicles));
  }
}

void finishVehicles(Scope& scope) {
  ir::Mission& mission = scope.mission;
  mission.vehicles = scope.vehicles;
  bool any = false;
  for (const auto& [name, named] : scope.named_sensors) {
    const ir::SensorId id = scope.subscribed(named.sensor);
    if (id.valid()) {
      shareCalled(named.share, mission).named.push_back({named.address, id});
      any = true;
    }
  }
  for (ir::Share& share : mission.shares) {
    std::ranges::sort(share.named, {}, &ir::FromVehicle::address);
  }
  // A program also reads the depth, to begin.
  constexpr size_t kMost = ir::kMostReadings - 1;
  const bool crowded = scope.named_sensors.size() > Scope::kMostNamedSensors;
  if ((any && mission.sensors.size() > kMost) || crowded) {
    scope.report(support::diagnostics::tooManyReceived, scope.named_sensors.begin()->second.where,
                 std::max(mission.sensors.size(), scope.named_sensors.size()), kMost);
  }
}

}  // namespace glider::frontend
