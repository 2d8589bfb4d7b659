// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/types.h"

#include "support/units/units.h"

#include <fmt/format.h>

namespace glider::frontend {
namespace {

/// A value of that dimension with a unit; empty if no unit has that dimension.
std::string exampleOf(support::Dimension dimension) {
  if (dimension.dimensionless()) {
    return "5";
  }
  if (dimension == support::dimension::angle) {
    return "26 deg";
  }
  const std::string unit = support::unitName(dimension);
  const auto parsed = support::parseUnit(unit);
  return parsed && parsed->dimension == dimension ? "5 " + unit : "";
}

std::string exampleOf(const DeclaredType& type) {
  if (type.path) {
    return "[39.2 N 73.9 W, 39.3 N 73.8 W]";
  }
  if (type.position) {
    return "39.2 N 73.9 W";
  }
  switch (type.type.kind) {
    case ir::TypeKind::Bool:
      return "depth > 5 m";
    case ir::TypeKind::Latitude:
      return "39.2 N";
    case ir::TypeKind::Longitude:
      return "73.9 W";
    case ir::TypeKind::Quantity:
      break;
  }
  return exampleOf(type.type.dimension);
}

}  // namespace

std::string describe(const ir::Type& type) {
  switch (type.kind) {
    case ir::TypeKind::Bool:
      return "a condition";
    case ir::TypeKind::Latitude:
      return "a latitude";
    case ir::TypeKind::Longitude:
      return "a longitude";
    case ir::TypeKind::Quantity:
      break;
  }
  if (type.dimension.dimensionless()) {
    return "a plain number";
  }
  const std::string unit = support::unitName(type.dimension);
  const std::string name = support::describe(type.dimension);
  if (name == unit) {
    return "a quantity in " + unit;
  }
  const bool vowel = std::string_view("aeiou").find(name.front()) != std::string_view::npos;
  return fmt::format("{} {} ({})", vowel ? "an" : "a", name, unit);
}

std::string describe(const DeclaredType& type) {
  return type.path ? "a path" : type.position ? "a position" : describe(type.type);
}

std::string howToWrite(const DeclaredType& type) {
  const std::string example = exampleOf(type);
  return example.empty() ? fmt::format("combine values with units into {}", describe(type))
                         : fmt::format("write {} such as `{}`", describe(type), example);
}

std::string pilotsUnit(support::Dimension dimension) {
  return dimension == support::dimension::angle    ? "deg"
         : dimension == support::dimension::energy ? "Wh"
                                                   : std::string(support::unitName(dimension));
}

std::optional<DeclaredType> findType(std::string_view name) {
  if (name == "bool") {
    return DeclaredType{boolean()};
  }
  if (name == "latitude" || name == "longitude") {
    return DeclaredType{name == "latitude" ? latitude() : longitude()};
  }
  if (name == "position" || name == "path") {
    return DeclaredType{latitude(), name == "position", name == "path"};
  }
  if (const auto dimension = support::findDimension(name)) {
    return DeclaredType{quantity(*dimension)};
  }
  const size_t split = name.find_last_of("*/");
  if (split == std::string_view::npos) {
    return std::nullopt;
  }
  const auto left = findType(name.substr(0, split));
  const auto right = support::findDimension(name.substr(split + 1));
  if (!left || left->position || left->path || left->type.kind != ir::TypeKind::Quantity ||
      !right) {
    return std::nullopt;
  }
  const auto whole = name[split] == '*' ? support::product(left->type.dimension, *right)
                                        : support::quotient(left->type.dimension, *right);
  return whole ? std::optional(DeclaredType{quantity(*whole)}) : std::nullopt;
}

bool isUnitName(std::string_view name) {
  const auto unit = support::findUnit(name);
  return (unit && !unit->soft) || name == "N" || name == "S" || name == "E" || name == "W";
}

}  // namespace glider::frontend
