// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/types.h"

#include <optional>
#include <string>
#include <string_view>

namespace glider::frontend {

/// "a length (m)", "an angle (rad)", "a latitude", "a condition", "a plain number", "a quantity in
/// degC/m".
std::string describe(const ir::Type& type);

/// A type as it is written: in the IR a position is two numbers, and a path is none.
struct DeclaredType {
  ir::Type type;  ///< for a position and a path: a latitude
  bool position = false;
  bool path = false;
  bool operator==(const DeclaredType&) const = default;
};
std::string describe(const DeclaredType& type);
/// How to write a value of the type, as a hint: "write a length (m) such as `5 m`".
std::string howToWrite(const DeclaredType& type);

/// The unit in which pilots write such a value: "m", "deg".
std::string pilotsUnit(support::Dimension dimension);

/// The meaning of a type's name in the language: "length", "bool", "latitude", "position", "path",
/// "temperature/length"; empty: none.
std::optional<DeclaredType> findType(std::string_view name);

/// Whether `name` is a unit or a letter of positions, which cannot name a value.
bool isUnitName(std::string_view name);

using ir::boolean;
using ir::latitude;
using ir::longitude;
using ir::plainNumber;
using ir::quantity;

}  // namespace glider::frontend
