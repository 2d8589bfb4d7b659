// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/parameter_info.h"

#include "runtime/abi/glider_abi.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>

namespace glider::ir {
namespace {

std::string row(std::string_view spelling, double factor) {
  return fmt::format("{}={:016x}", spelling, std::bit_cast<uint64_t>(factor));
}

/// The greatest value of a latitude or longitude, degrees; infinite for other types.
double mostOnEarth(const Type& type) {
  switch (type.kind) {
    case TypeKind::Latitude:
      return 90;
    case TypeKind::Longitude:
      return 180;
    case TypeKind::Bool:
    case TypeKind::Quantity:
      break;
  }
  return Variable::kEndless;
}

}  // namespace

std::string unitFactors(const Type& type) {
  switch (type.kind) {
    case TypeKind::Bool:
      return "bool";
    case TypeKind::Latitude:
      return row("N", 1) + " " + row("S", -1);
    case TypeKind::Longitude:
      return row("E", 1) + " " + row("W", -1);
    case TypeKind::Quantity:
      break;
  }
  const std::string compound = support::unitName(type.dimension);
  const support::Unit bare =
      support::bareUnit(type.dimension).value_or(support::Unit{compound, type.dimension, 1});
  std::vector<std::string> rows{row(bare.spelling, bare.to_si)};
  for (const support::Unit& unit : support::unitsOf(type.dimension)) {
    if (unit.spelling != bare.spelling) {
      rows.push_back(row(unit.spelling, unit.to_si));
    }
  }
  return fmt::to_string(fmt::join(rows, " "));
}

std::vector<ParameterInfo> parameterInfos(const Mission& mission) {
  std::vector<ParameterInfo> infos;
  for (const Variable& parameter : mission.variables) {
    if (parameter.kind != VariableKind::Parameter) {
      continue;
    }
    const Expr& initial = mission[parameter.initial];
    const double truth = initial.op == Op::True ? 1 : 0;
    const double most = mostOnEarth(parameter.type);
    const bool time = parameter.type.kind == TypeKind::Quantity &&
                      parameter.type.dimension == support::dimension::time;
    infos.push_back(
        {.name = parameter.name,
         .initial = initial.op == Op::Constant ? initial.number : truth,
         .lowest = std::max(parameter.lowest, -most),
         .highest = std::min(parameter.highest, most),
         .units = parameter.unit.empty()
                      ? unitFactors(parameter.type)
                      : row(parameter.unit, support::findUnit(parameter.unit).value().to_si),
         .date = time && initial.op == Op::Constant && initial.number >= GLIDER_FIRST_DATE});
  }
  return infos;
}

}  // namespace glider::ir
