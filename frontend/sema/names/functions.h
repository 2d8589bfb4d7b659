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

/// A function of expressions whose value is one operation.
struct Function {
  std::string_view name;
  ir::Op op;
  std::string_view arguments;  ///< as messages name them: "x, lowest, highest"

  [[nodiscard]] size_t argumentCount() const;
};

/// The function of one operation that `name` is; null if none.
const Function* findFunction(std::string_view name);

/// What `name` is over a window: mean, lowest, highest, spread, rate, slope.
std::optional<ir::TemporalKind> findWindow(std::string_view name);

/// Whether `name` is a function that takes places.
bool isEarthFunction(std::string_view name);

/// Whether `name` is a function of expressions, of whatever sort.
bool isFunctionName(std::string_view name);

/// All of them.
const std::vector<std::string_view>& functionNames();

/// A function as a pilot reads of it.
struct FunctionText {
  std::string_view name;
  std::string_view use;   ///< "clamp(x, lowest, highest)"
  std::string_view what;  ///< one line
};
/// All of them, in the order of functionNames.
std::span<const FunctionText> functionTexts();

}  // namespace glider::frontend
