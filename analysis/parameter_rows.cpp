// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/parameter_rows.h"

#include "flights/parameter_table.h"
#include "runtime/launch/launch.h"

#include <array>

namespace glider::analysis {
namespace {

template <typename Write>
std::string written(Write write) {
  std::array<char, 120> bytes{};
  runtime::Text text(bytes.data(), bytes.size());
  write(text);
  return {text.bytes(), text.size()};
}

std::string typeName(const ir::Type& type) {
  switch (type.kind) {
    case ir::TypeKind::Bool:
      return "bool";
    case ir::TypeKind::Latitude:
      return "latitude";
    case ir::TypeKind::Longitude:
      return "longitude";
    case ir::TypeKind::Quantity:
      break;
  }
  return support::describe(type.dimension);
}

ParameterRow rowOf(const ir::Variable& variable, const GliderParameterInfo& info, double value) {
  auto quantity = [&](double of) {
    return written([&](runtime::Text& text) { runtime::writeQuantity(info, of, text); });
  };
  return {variable.name, typeName(variable.type), quantity(info.initial),
          written([&](runtime::Text& text) { runtime::writeRange(info, text); }),
          value == info.initial ? "" : quantity(value)};
}

}  // namespace

support::Result<std::vector<ParameterRow>> parameterRows(const compiler::Optimised& mission,
                                                         const flights::LaunchChoice& choice) {
  const flights::ParameterTable table(mission.mission);
  const auto values = flights::chooseParameters(mission.mission, choice);
  if (!values) {
    return std::unexpected(values.error());
  }
  std::vector<ParameterRow> rows;
  for (size_t i = 0; i < values->size(); ++i) {
    rows.push_back(rowOf(mission.mission.variables[i], table[i], values->at(i)));
  }
  return rows;
}

}  // namespace glider::analysis
