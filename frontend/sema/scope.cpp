// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/scope.h"

#include "frontend/sema/lower_expr.h"
#include "frontend/spelling.h"

#include <fmt/format.h>

#include <algorithm>
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
  behaviour.name = declaration.name->text;
  behaviour.kind = declaration.kind;
  if (declaration.body == nullptr) {
    behaviour.symbol = symbolOf(declaration.kind, declaration.name->text);
    behaviour.parameters = declaration.signature.slots;
  }
  for (const platforms::PlatformSensor* sensor : declaration.reads) {
    behaviour.reads.push_back(
        subscribe(*sensor, sensor->alias.empty() ? sensor->name : sensor->alias));
  }
  declaration.id = {static_cast<uint32_t>(mission.behaviours.size())};
  mission.behaviours.push_back(std::move(behaviour));
  return declaration.id;
}

std::string Scope::suggestSensor(std::string_view wrong) const {
  std::vector<std::string_view> known(std::begin(kClocks), std::end(kClocks));
  for (const platforms::PlatformSensor& sensor : platform().sensors) {
    known.push_back(sensor.alias.empty() ? sensor.name : sensor.alias);
  }
  for (const platforms::PlatformSensor& sensor : platform().sensors) {
    known.push_back(sensor.name);
  }
  return didYouMean(wrong, known, "its sensors stand in platforms/" + platform().name + ".toml");
}

std::string Scope::suggestName(std::string_view wrong) const {
  std::vector<std::string_view> known;
  for (const Names* list : visibleNames()) {
    for (const auto& [name, named] : *list) {
      known.push_back(name);
    }
  }
  for (const auto& [name, constant] : constants) {
    if (!context.isolated) {
      known.push_back(name);
    }
  }
  const std::string near = didYouMean(wrong, known, "");
  return near.empty() ? suggestSensor(wrong) : near;
}

std::string Scope::takenBy(std::string_view name) const {
  if (findClock(name)) {
    return "a clock";
  }
  if (platform().find(name) != nullptr) {
    return "a sensor of platform `" + platform().name + "`";
  }
  if (isFunctionName(name)) {
    return "a function";
  }
  return name == "profiledone" || name == "routedone" ? "a word of the language" : "";
}

bool Scope::refuseUnseen(std::string_view name, const support::SourceRange& range) {
  if (context.isolated) {
    const auto constant = constants.find(name);
    const auto named = names.find(name);
    const ast::Name* there = constant != constants.end() ? constant->second.name
                             : named != names.end()      ? named->second.name
                                                         : nullptr;
    if (there != nullptr) {
      report(DiagnosticId::ofTheMission, range, name).note(there->where, "it is defined here");
    }
    return there != nullptr;
  }
  for (const StateDeclaration& state : state_declarations) {
    if (const auto found = state.names.find(name); found != state.names.end()) {
      report(DiagnosticId::ofAnotherState, range, name, state.node->name.text)
          .note(found->second.name->where, "it is defined here");
      return true;
    }
  }
  return false;
}

bool Scope::refuseName(const ast::Name& name, std::string_view owner) {
  if (isUnitName(name.text)) {
    report(DiagnosticId::unitAsName, name.where, name.text, owner);
    return true;
  }
  const std::string what = takenBy(name.text);
  if (!what.empty()) {
    report(DiagnosticId::nameTaken, name.where, name.text, what);
    refused_names.insert(name.text);
  }
  return !what.empty();
}

bool Scope::refuseSecond(const ast::Name& name) {
  const Named* named = findNamed(name.text);
  const Constant* constant = findConstant(name.text);
  const ast::Name* first = named != nullptr      ? named->name
                           : constant != nullptr ? constant->name
                                                 : nullptr;
  if (first == nullptr) {
    return false;
  }
  report(DiagnosticId::duplicateName, name.where, name.text)
      .note(first->where, "the first is here");
  return true;
}

Named* Scope::findNamed(std::string_view name) {
  if (context.names != nullptr) {
    if (const auto own = context.names->find(name); own != context.names->end()) {
      return &own->second;
    }
  }
  const auto found = context.isolated ? names.end() : names.find(name);
  return found == names.end() ? nullptr : &found->second;
}

const Constant* Scope::findConstant(std::string_view name) const {
  const auto found = context.isolated ? constants.end() : constants.find(name);
  return found == constants.end() ? nullptr : &found->second;
}

std::vector<const Names*> Scope::visibleNames() const {
  std::vector<const Names*> lists;
  if (context.names != nullptr) {
    lists.push_back(context.names);
  }
  if (!context.isolated) {
    lists.push_back(&names);
  }
  return lists;
}

std::string Scope::freshName(std::string wish) {
  while (!variable_names_.insert(wish).second) {
    wish += '_';
  }
  return wish;
}

std::optional<DeclaredType> Scope::declaredType(const ast::TypeName& name,
                                                std::string_view holder) {
  if (const auto found = findType(name.text)) {
    if (!found->path || holder.empty()) {
      return found;
    }
    report(DiagnosticId::pathElsewhere, name.where, holder);
    return std::nullopt;
  }
  static const std::vector<std::string_view> kTypes = {
      "bool", "latitude", "longitude", "position", "path",
#define DIMENSION(name, m, kg, s, a, k, rad, unit) #name,
#include "support/units/dimensions.def"
#undef DIMENSION
  };
  std::string all;
  for (std::string_view type : kTypes) {
    all += (all.empty() ? "types: " : ", ") + std::string(type);
  }
  report(DiagnosticId::unknownType, name.where, name.text, didYouMean(name.text, kTypes, all));
  return std::nullopt;
}

Signature Scope::signatureOf(const ast::Name& name,
                             const std::optional<std::vector<ast::Formal>>& formals,
                             std::string_view holder) {
  Signature result;
  for (const ast::Formal& formal : formals.value_or(std::vector<ast::Formal>())) {
    result.text += fmt::format("{}{}: {}", result.text.empty() ? "" : ", ", formal.name.text,
                               formal.type.text);
  }
  result.text = name.text + (result.text.empty() ? "" : "(" + result.text + ")");
  if (!formals) {
    return result;
  }
  for (const ast::Formal& formal : *formals) {
    const auto type = declaredType(formal.type, holder);
    result.valid = result.valid && type.has_value();
    const DeclaredType known = type.value_or(DeclaredType{plainNumber(), false});
    result.formals.push_back({&formal.name, known});
    if (known.path) {
      continue;
    }
    if (known.position) {
      result.slots.push_back({formal.name.text + ".latitude", latitude()});
      result.slots.push_back({formal.name.text + ".longitude", longitude()});
    } else {
      result.slots.push_back({formal.name.text, known.type});
    }
  }
  return result;
}

}  // namespace glider::frontend
