// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/symbols/type_texts.h"

#include "frontend/sema/declarations/declarations.h"
#include "frontend/sema/names/scope.h"
#include "ir/core/type_name.h"

#include <fmt/format.h>

namespace glider::frontend {
namespace {

constexpr std::string_view kDimensions[] = {
#define DIMENSION(name, m, kg, s, a, k, rad, unit) #name,
#include "support/units/dimensions.def"
#undef DIMENSION
};

/// `temperature/length`: the first product or quotient of two named dimensions that is `dimension`.
std::string compound(support::Dimension dimension) {
  for (std::string_view left : kDimensions) {
    for (std::string_view right : kDimensions) {
      const auto a = *support::findDimension(left);
      const auto b = *support::findDimension(right);
      if (support::quotient(a, b) == dimension || support::product(a, b) == dimension) {
        const char* sign = support::quotient(a, b) == dimension ? "/" : "*";
        return std::string(left) + sign + std::string(right);
      }
    }
  }
  return "";
}

std::string typeOf(const ir::Type& type) {
  const auto name = ir::typeName(type);
  return name ? *name : compound(type.dimension);
}

std::string typeOf(const Constant& constant) {
  if (!constant.elements.empty()) {
    return fmt::format("{}[{}]", typeOf(constant.type), constant.elements.size());
  }
  return !constant.path.empty() ? "path" : constant.position ? "position" : typeOf(constant.type);
}

}  // namespace

std::string knownType(std::string_view written) {
  return findType(written) ? std::string(written) : "";
}

std::string unitOf(std::string_view written) {
  const auto type = findType(written);
  return type && type->type.kind == ir::TypeKind::Quantity ? support::unitName(type->type.dimension)
                                                           : "";
}

std::string typeOf(const platforms::PlatformSensor& sensor) {
  switch (sensor.kind) {
    case platforms::SensorKind::Latitude:
      return "latitude";
    case platforms::SensorKind::Longitude:
      return "longitude";
    case platforms::SensorKind::Quantity:
      break;
  }
  return typeOf(quantity(sensor.dimension));
}

ConstantTypes constantTypes(const ast::File& mission, const AnalysisInputs& inputs) {
  support::DiagnosticEngine quiet;
  Scope scope(inputs, quiet);
  for (const ast::File* library : inputs.library) {
    declare(*library, true, scope);
  }
  declare(mission, false, scope);
  ConstantTypes types;
  for (const auto& [name, constant] : scope.constants) {
    if (constant.valid) {
      const ast::Where& where = constant.name->where;
      types.emplace(std::pair(where.file, where.begin), typeOf(constant));
    }
  }
  return types;
}

}  // namespace glider::frontend
