// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/type_name.h"

namespace glider::ir {

std::optional<std::string> typeName(const Type& type) {
  switch (type.kind) {
    case TypeKind::Bool:
      return "bool";
    case TypeKind::Latitude:
      return "latitude";
    case TypeKind::Longitude:
      return "longitude";
    case TypeKind::Quantity:
      break;
  }
  if (type.dimension.dimensionless()) {
    return "number";
  }
  std::string name = support::describe(type.dimension);
  const bool named = support::findDimension(name) == type.dimension;
  return named ? std::optional(std::move(name)) : std::nullopt;
}

}  // namespace glider::ir
