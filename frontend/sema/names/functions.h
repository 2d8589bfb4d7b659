// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// A function of expressions that is one operation.
struct Function {
  std::string_view name;
  ir::Op op;
  std::string_view arguments;  ///< as messages name them: "x, lowest, highest"

  [[nodiscard]] size_t argumentCount() const;
};

/// The function called `name` that is one operation; null if there is none.
const Function* findFunction(std::string_view name);

/// The window function called `name`: mean, lowest, depth_of_lowest, rate, slope and so on.
std::optional<ir::TemporalKind> findWindow(std::string_view name);

/// Whether `name` is a function that takes places.
bool isEarthFunction(std::string_view name);

/// Whether `name` is a function that gives a place, unless the mission uses the name itself.
bool isPlaceFunction(std::string_view name);

/// Whether `name` is a function that gives a heading, unless the mission uses the name itself.
bool isHeadingFunction(std::string_view name);

/// Whether a mission cannot use `name` itself, as it is a function.
bool isReservedFunction(std::string_view name);

/// Whether `name` is a function of expressions of any kind.
bool isFunctionName(std::string_view name);

/// The names of all functions.
const std::vector<std::string_view>& functionNames();

/// The description of a function for pilots.
struct FunctionText {
  std::string_view name;
  std::string_view use;   ///< "clamp(x, lowest, highest)"
  std::string_view what;  ///< one line
};
/// All of them, in the order of functionNames.
std::span<const FunctionText> functionTexts();

}  // namespace glider::frontend
