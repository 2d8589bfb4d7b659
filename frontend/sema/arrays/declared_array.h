// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace glider::frontend {

/// How many elements an array may have.
inline constexpr size_t kFewestElements = 2;
inline constexpr size_t kMostElements = 64;

/// The number of elements that `[size]` after a name says; empty, and reported, if it is not
/// constant or out of range.
std::optional<size_t> arraySize(const ast::Expr& size, Scope& scope);

/// The initial value of each of the `size` elements of `name`: those of a list, or one value for
/// all of them. For a `size` of 0, which is not an array, the value alone. Empty, and reported, if
/// a list has another length.
std::optional<std::vector<const ast::Expr*>> startsOf(const ast::Name& name, size_t size,
                                                      const ast::Expr& value, Scope& scope);

}  // namespace glider::frontend
