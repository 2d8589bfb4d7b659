// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/externals.h"

#include "frontend/sema/declarations/declared_value.h"
#include "frontend/sema/declarations/formal_ranges.h"
#include "frontend/sema/names/commands.h"
#include "support/diagnostics/ids/meaning.h"

#include <algorithm>
#include <map>

namespace glider::frontend {

namespace {

/// A reading of the SBC's own sensor is unknown after this time, unless its declaration says
/// otherwise: the usual time of the vehicle's sensors.
constexpr double kStaleAfter_s = 20;

/// True, and reported, if a declaration cannot have this name.
bool refuse(const ast::Name& name, std::string_view owner, Scope& scope) {
  return scope.refuseName(name, owner) || scope.refuseSecond(name);
}

/// Refuses a type that C cannot return as a single number, or not here: `fault` says which.
void refuseType(const ast::Name& name, const DeclaredType& type, std::string_view fault,
                std::string_view hint, const ast::TypeName& where, Scope& scope) {
  scope.report(support::diagnostics::externType, where.where, name.text, describe(type), fault,
               hint);
}

void checkParameters(const Signature& signature, Scope& scope) {
  std::map<std::string_view, const ast::Name*> names;
  for (const Signature::Formal& formal : signature.formals) {
    if (isUnitName(formal.name->text)) {
      scope.report(support::diagnostics::unitAsName, formal.name->where, formal.name->text,
                   "a parameter");
    }
    const auto [place, fresh] = names.emplace(formal.name->text, formal.name);
    if (!fresh) {
      scope.report(support::diagnostics::duplicateName, formal.name->where, formal.name->text)
          .note(place->second->where, "the first is here");
    }
  }
}

/// The parameters of a C function; their names are only for the reader.
Signature signatureInC(const ast::Name& name, std::span<const ast::Formal> formals, Scope& scope) {
  Signature signature = scope.signatureOf(name, formals, "a parameter of a C function");
  settleRanges(signature, scope);
  checkParameters(signature, scope);
  return signature;
}

/// The type of what C returns as `role`; empty, and reported with `fault` and `hint`, if it is a
/// position: two numbers.
std::optional<DeclaredType> oneNumber(const ast::Name& name, const ast::TypeName& written,
                                      std::string_view role, std::string_view fault,
                                      std::string_view hint, Scope& scope) {
  const auto type = scope.declaredType(written, role);
  if (type && type->position) {
    refuseType(name, *type, fault, hint, written, scope);
    return std::nullopt;
  }
  return type;
}

/// The type of a function's result; empty, and reported, if there is none or it is two numbers.
std::optional<DeclaredType> resultType(const ast::ExternFunction& node, Scope& scope) {
  return oneNumber(node.name, node.result, "the value of a C function",
                   "a C function returns one number",
                   "declare two functions, one for the latitude and one for the longitude", scope);
}

/// The type of a sensor; empty, and reported, if its reading is not one number.
std::optional<DeclaredType> readingType(const ast::ExternSensor& node, Scope& scope) {
  const auto type =
      oneNumber(node.name, node.type, "a sensor's reading", "a reading is one number",
                "declare two sensors, one for the latitude and one for the longitude", scope);
  if (type && type->type == boolean()) {
    refuseType(node.name, *type, "a reading is a number",
               "write `: number in 0 .. 1`, and compare it", node.type, scope);
    return std::nullopt;
  }
  return type;
}

/// How long a reading is valid; empty, and reported, if that is not a time above 0.
std::optional<double> staleAfter(const ast::ExternSensor& node, Scope& scope) {
  if (!node.stale_after) {
    return kStaleAfter_s;
  }
  const DeclaredType time{quantity(support::dimension::time)};
  const ast::Name role{"stale after", node.stale_after->where};
  const auto known =
      DeclaredValue(role, time, scope).constant(*node.stale_after, "the time after `stale`");
  if (known && !(known->first > 0)) {
    scope.report(support::diagnostics::staleNotPositive, node.stale_after->where,
                 scope.text(node.stale_after->where));
    return std::nullopt;
  }
  return known ? std::optional(known->first) : std::nullopt;
}

}  // namespace

platforms::SensorKind kindOf(const ir::Type& type) {
  return type == latitude()    ? platforms::SensorKind::Latitude
         : type == longitude() ? platforms::SensorKind::Longitude
                               : platforms::SensorKind::Quantity;
}

void enterExternal(const ast::ExternFunction& node, Scope& scope) {
  if (isCommandName(node.name.text)) {
    scope.report(support::diagnostics::nameTaken, node.name.where, node.name.text, "a command");
    scope.refused_names.insert(node.name.text);
  } else if (!refuse(node.name, "a function", scope)) {
    scope.functions[node.name.text].name = &node.name;
  }
}

void enterExternal(const ast::ExternSensor& node, Scope& scope) {
  if (refuse(node.name, "a sensor", scope)) {
    return;
  }
  const size_t number = scope.own_sensors.size();
  if (number == Scope::kMostOwnSensors) {
    scope.report(support::diagnostics::tooManyOwnSensors, node.name.where, node.name.text,
                 Scope::kMostOwnSensors);
    scope.refused_names.insert(node.name.text);
    return;
  }
  OwnSensor& own = scope.own_sensors[node.name.text];
  own.name = &node.name;
  own.sensor.id = static_cast<uint16_t>(ir::kFirstOwnSensor + number);
  own.sensor.name = node.name.text;
}

void declareExternal(const ast::ExternFunction& node, Scope& scope) {
  const auto found = scope.functions.find(node.name.text);
  if (found == scope.functions.end() || found->second.name != &node.name) {
    return;  // refused
  }
  FunctionDeclaration& function = found->second;
  function.signature = signatureInC(node.name, node.formals, scope);
  if (node.formals.empty()) {
    function.signature.text += "()";
  }
  const size_t numbers = function.signature.slots.size();
  const bool few = numbers <= ir::kMostOperands;
  if (!few) {
    scope.report(support::diagnostics::tooManyNumbers, node.name.where, node.name.text, numbers,
                 ir::kMostOperands);
  }
  const auto type = resultType(node, scope);
  const auto bounds =
      type ? DeclaredValue(node.name, *type, scope).bounds(node.range) : std::nullopt;
  function.usable = function.signature.valid && few && bounds;
  if (bounds) {
    function.result = type->type;
    function.lowest = bounds->lowest;
    function.highest = bounds->highest;
  }
}

void declareExternal(const ast::ExternSensor& node, Scope& scope) {
  const auto found = scope.own_sensors.find(node.name.text);
  if (found == scope.own_sensors.end() || found->second.name != &node.name) {
    return;  // refused
  }
  const auto type = readingType(node, scope);
  const auto bounds =
      type ? DeclaredValue(node.name, *type, scope).bounds(node.range) : std::nullopt;
  const auto stale_after = staleAfter(node, scope);
  found->second.usable = bounds && stale_after;
  if (!found->second.usable) {
    scope.refused_names.insert(node.name.text);
    return;
  }
  platforms::PlatformSensor& sensor = found->second.sensor;
  sensor.kind = kindOf(type->type);
  sensor.dimension = type->type.dimension;
  sensor.lowest = bounds->lowest;
  sensor.highest = bounds->highest;
  sensor.stale_after_s = *stale_after;
}

BehaviourDeclaration externalBehaviour(const ast::ExternBehaviour& node, Scope& scope) {
  BehaviourDeclaration declaration;
  declaration.signature = signatureInC(node.name, listOf(node.formals), scope);
  declaration.usable = declaration.signature.valid;
  for (const ast::Name& sensor : node.reads) {
    const platforms::PlatformSensor* found = scope.findSensor(sensor.text);
    if (found != nullptr) {
      declaration.reads.push_back(found);
      continue;
    }
    declaration.usable = false;
    if (!scope.refused_names.contains(sensor.text)) {
      scope.reportUnknown(support::diagnostics::unknownSensor, sensor.where,
                          scope.suggestSensor(sensor.text), scope.platform().name, sensor.text);
    }
  }
  return declaration;
}

}  // namespace glider::frontend
