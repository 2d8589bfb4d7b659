// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/outline.h"
#include "frontend/symbols.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace glider::frontend {

/// Indices of symbols by name.
using Indices = std::map<std::string, uint32_t, std::less<>>;

/// A state, profile or route with its own names.
struct SymbolBody {
  support::SourceRange where;
  std::optional<uint32_t> owner;  ///< its index; none: the mission may not use it
  bool isolated = false;          ///< it cannot use names of the mission
  Indices names;
};

/// Resolves names; states, profiles and routes, functions, commands and values have separate name
/// spaces.
class Meanings {
 public:
  /// If two have the same name, the first entered applies.
  void enter(const Symbol& symbol, uint32_t index);
  /// The index of the meaning of `name`; `body`: the body that contains it; null: none.
  [[nodiscard]] std::optional<uint32_t> find(Naming naming, std::string_view name,
                                             const SymbolBody* body) const;

 private:
  static constexpr size_t kKinds = static_cast<size_t>(SymbolKind::Command) + 1;
  /// The lowest index of all symbols with that name and one of `kinds`.
  [[nodiscard]] std::optional<uint32_t> first(std::initializer_list<SymbolKind> kinds,
                                              std::string_view name) const;

  std::array<Indices, kKinds> names_;
};

}  // namespace glider::frontend
