// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/types.h"

#include "support/units/units.h"

#include <fmt/format.h>

namespace glider::frontend {

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
  return support::findUnit(name).has_value() || name == "N" || name == "S" || name == "E" ||
         name == "W";
}

}  // namespace glider::frontend
