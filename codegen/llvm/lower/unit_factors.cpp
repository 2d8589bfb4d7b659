// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/unit_factors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <vector>

namespace glider::codegen {
namespace {

std::string row(std::string_view spelling, double factor) {
  return fmt::format("{}={:016x}", spelling, std::bit_cast<uint64_t>(factor));
}

}  // namespace

std::string unitFactors(const ir::Type& type) {
  switch (type.kind) {
    case ir::TypeKind::Bool:
      return "bool";
    case ir::TypeKind::Latitude:
      return row("N", 1) + " " + row("S", -1);
    case ir::TypeKind::Longitude:
      return row("E", 1) + " " + row("W", -1);
    case ir::TypeKind::Quantity:
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

}  // namespace glider::codegen
