// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The sensors, tables, functions and behaviours of a mission: those that it uses, each once.

#include "frontend/sema/names/scope.h"

#include <algorithm>

namespace glider::frontend {
namespace {

ir::Type typeOf(const platforms::PlatformSensor& sensor) {
  switch (sensor.kind) {
    case platforms::SensorKind::Latitude:
      return {ir::TypeKind::Latitude, {}};
    case platforms::SensorKind::Longitude:
      return {ir::TypeKind::Longitude, {}};
    case platforms::SensorKind::Quantity:
      break;
  }
  return quantity(sensor.dimension);
}

ir::Sensor irSensor(const platforms::PlatformSensor& sensor, std::string_view written) {
  const bool own = sensor.id >= ir::kFirstOwnSensor;
  const bool of_vehicle = sensor.id < ir::kFirstHeardSensor;
  const bool minutes = of_vehicle && sensor.kind != platforms::SensorKind::Quantity;
  return {std::string(written),
          sensor.name,
          sensor.id,
          typeOf(sensor),
          minutes                         ? ir::Encoding::DegreesMinutes
          : of_vehicle && sensor.magnetic ? ir::Encoding::Magnetic
                                          : ir::Encoding::Linear,
          sensor.to_si,
          sensor.lowest,
          sensor.highest,
          sensor.stale_after_s,
          own ? ir::sensorSymbol(sensor.name, typeOf(sensor)) : ""};
}

ir::Function functionInC(const FunctionDeclaration& declaration) {
  const std::string& name = declaration.name->text;
  return {name,
          ir::functionSymbol(name, declaration.signature.slots, declaration.result),
          declaration.signature.slots,
          declaration.result,
          declaration.lowest,
          declaration.highest};
}

ir::Behaviour behaviourInC(const BehaviourDeclaration& declaration) {
  std::vector<ir::OwnRead> own;
  for (const platforms::PlatformSensor* sensor : declaration.reads) {
    if (sensor->id >= ir::kFirstOwnSensor) {
      own.push_back({sensor->name, sensor->id});
    }
  }
  const std::string& name = declaration.name->text;
  const auto& parameters = declaration.signature.slots;
  return {name,
          ir::behaviourSymbol(declaration.kind, name, parameters, own),
          declaration.kind,
          parameters,
          {}};
}

}  // namespace

ir::FunctionId Scope::function(const FunctionDeclaration& declaration) {
  const auto found =
      std::ranges::find(mission.functions, declaration.name->text, &ir::Function::name);
  const auto index = static_cast<uint32_t>(found - mission.functions.begin());
  if (found == mission.functions.end()) {
    mission.functions.push_back(functionInC(declaration));
  }
  return {index};
}

ir::SensorId Scope::subscribe(const platforms::PlatformSensor& sensor, std::string_view written) {
  if (const auto known = subscribed_.find(sensor.id); known != subscribed_.end()) {
    return known->second;
  }
  const ir::SensorId id{static_cast<uint32_t>(mission.sensors.size())};
  mission.sensors.push_back(irSensor(sensor, written));
  subscribed_.emplace(sensor.id, id);
  return id;
}

ir::SensorId Scope::subscribed(const platforms::PlatformSensor& sensor) const {
  const auto known = subscribed_.find(sensor.id);
  return known != subscribed_.end() ? known->second : ir::SensorId();
}

ir::TableId Scope::table(ir::Table table) {
  const auto found = std::ranges::find(mission.tables, table);
  const auto index = static_cast<uint32_t>(found - mission.tables.begin());
  if (found == mission.tables.end()) {
    mission.tables.push_back(std::move(table));
  }
  return {index};
}

ir::BehaviourId Scope::use(BehaviourDeclaration& declaration) {
  if (declaration.id.valid()) {
    return declaration.id;
  }
  ir::Behaviour behaviour;
  if (declaration.body == nullptr) {
    behaviour = behaviourInC(declaration);
  }
  behaviour.name = declaration.name->text;
  behaviour.kind = declaration.kind;
  for (const platforms::PlatformSensor* sensor : declaration.reads) {
    behaviour.reads.push_back(
        subscribe(*sensor, sensor->alias.empty() ? sensor->name : sensor->alias));
  }
  declaration.id = {static_cast<uint32_t>(mission.behaviours.size())};
  mission.behaviours.push_back(std::move(behaviour));
  return declaration.id;
}

ir::CInterface Scope::declaredInC() const {
  ir::CInterface result;
  for (const auto& [name, function] : functions) {
    result.functions.push_back(functionInC(function));
  }
  for (const auto& [name, own] : own_sensors) {
    result.sensors.push_back(irSensor(own.sensor, name));
  }
  for (const auto& [name, behaviour] : behaviours) {
    if (behaviour.body == nullptr) {
      result.behaviours.push_back(behaviourInC(behaviour));
    }
  }
  return result;
}

support::DiagnosticBuilder Scope::refuseOverTime(const support::SourceRange& range,
                                                 std::string_view what) {
  return report(support::diagnostics::overTimeNowhere, range, what,
                context.requirement ? "in a requirement" : "in this value");
}

std::string Scope::listedStates() const {
  std::string all;
  for (const auto& [name, id] : states) {
    all += (all.empty() ? "states: " : ", ") + name;
  }
  return all;
}

}  // namespace glider::frontend
