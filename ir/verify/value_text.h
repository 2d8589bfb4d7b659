// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>
#include <string_view>

namespace glider::ir {

/// A number (SI units; for a position degrees) in the unit in which its type is shown: "12 m",
/// "39 10.500 N".
std::string withUnit(double value, Type type);
/// The same of a value of `variable`, which may count something: "200 uM", or be a condition:
/// "true".
std::string withUnit(double value, const Variable& variable);
/// The same of a plain number that counts `unit`, which may be none of the language.
std::string withCountedUnit(double value, Type type, std::string_view unit);
/// The same as `--set` takes it, with 15 digits: "12.25m", "39.2 S".
std::string withUnitExactly(double value, Type type);
/// The range of a variable: "3 m .. 24 m", "at most 5".
std::string rangeText(const Variable& variable);

}  // namespace glider::ir
