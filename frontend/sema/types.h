// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>
#include <string>
#include <string_view>

namespace glider::frontend {

/// "a length (m)", "an angle (rad)", "a latitude", "a condition", "a plain number", "a quantity in
/// degC/m".
std::string describe(const ir::Type& type);

/// What a type's name in the language means.
enum class NamedType : uint8_t { Known, Later, Unknown };
struct TypeLookup {
  NamedType status = NamedType::Unknown;
  ir::Type type;
};
/// "length", "bool", "latitude", "temperature/length"; `position` and `path` come later.
TypeLookup findType(std::string_view name);

/// Whether `name` is a unit or a letter of positions, which name no value.
bool isUnitName(std::string_view name);

inline ir::Type quantity(support::Dimension dimension) {
  return {ir::TypeKind::Quantity, dimension};
}
inline ir::Type plainNumber() {
  return quantity(support::dimension::number);
}
inline ir::Type boolean() {
  return {ir::TypeKind::Bool, {}};
}

}  // namespace glider::frontend
