// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/scope.h"

#include "frontend/spelling.h"

#include <cctype>

namespace glider::frontend {

using support::DiagnosticId;

namespace {

constexpr std::string_view kClocks[] = {"missiontime", "statetime", "resumetime"};

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

/// "gliderProfileYo" of "yo".
std::string symbolOf(ir::BehaviourKind kind, std::string name) {
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return (kind == ir::BehaviourKind::Profile ? "gliderProfile" : "gliderRoute") + name;
}

}  // namespace

std::optional<Clock> findClock(std::string_view name) {
  for (size_t i = 0; i < std::size(kClocks); ++i) {
    if (name == kClocks[i]) {
      return static_cast<Clock>(i);
    }
  }
  return std::nullopt;
}

void Scope::notYet(const support::SourceRange& range, std::string_view what,
                   std::string_view hint) {
  report(DiagnosticId::notYet, range, what, hint);
}

std::string Scope::text(const support::SourceRange& range) const {
  constexpr size_t kLongest = 60;
  std::string out;
  bool comment = false;
  for (char c : inputs_.sources.text(range)) {
    comment = c == '#' || (comment && c != '\n');
    const bool blank = comment || c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  return out.size() > kLongest ? out.substr(0, kLongest) + "…" : out;
}

ir::SensorId Scope::subscribe(const platforms::PlatformSensor& sensor, std::string_view written) {
  if (const auto known = subscribed_.find(sensor.id); known != subscribed_.end()) {
    return known->second;
  }
  const bool minutes = sensor.kind != platforms::SensorKind::Quantity;
  const ir::SensorId id{static_cast<uint32_t>(mission.sensors.size())};
  mission.sensors.push_back({std::string(written), sensor.name, sensor.id, typeOf(sensor),
                             minutes ? ir::Encoding::DegreesMinutes : ir::Encoding::Linear,
                             sensor.to_si, sensor.lowest, sensor.highest, sensor.stale_after_s});
  subscribed_.emplace(sensor.id, id);
  return id;
}

ir::BehaviourId Scope::use(BehaviourDeclaration& declaration) {
  if (declaration.id.valid()) {
    return declaration.id;
  }
  ir::Behaviour behaviour{declaration.name->text,
                          symbolOf(declaration.kind, declaration.name->text),
                          declaration.kind,
                          declaration.parameters,
                          {}};
  for (const platforms::PlatformSensor* sensor : declaration.reads) {
    behaviour.reads.push_back(
        subscribe(*sensor, sensor->alias.empty() ? sensor->name : sensor->alias));
  }
  declaration.id = {static_cast<uint32_t>(mission.behaviours.size())};
  mission.behaviours.push_back(std::move(behaviour));
  return declaration.id;
}

std::string Scope::suggestSensor(std::string_view wrong) const {
  std::vector<std::string_view> names(std::begin(kClocks), std::end(kClocks));
  for (const platforms::PlatformSensor& sensor : platform().sensors) {
    names.push_back(sensor.alias.empty() ? sensor.name : sensor.alias);
  }
  for (const platforms::PlatformSensor& sensor : platform().sensors) {
    names.push_back(sensor.name);
  }
  return didYouMean(wrong, names, "its sensors stand in platforms/" + platform().name + ".toml");
}

std::string Scope::suggestName(std::string_view wrong) const {
  std::vector<std::string_view> names;
  for (const auto& [name, constant] : constants) {
    names.push_back(name);
  }
  const std::string constant = didYouMean(wrong, names, "");
  return constant.empty() ? suggestSensor(wrong) : constant;
}

bool Scope::refuseName(const ast::Name& name, std::string_view owner) {
  if (isUnitName(name.text)) {
    report(DiagnosticId::unitAsName, name.where, name.text, owner);
    return true;
  }
  if (findClock(name.text) || platform().find(name.text) != nullptr) {
    report(DiagnosticId::nameTaken, name.where, name.text,
           findClock(name.text) ? std::string("a clock")
                                : "a sensor of platform `" + platform().name + "`");
    return true;
  }
  return false;
}

}  // namespace glider::frontend
