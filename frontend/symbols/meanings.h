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

/// Indices of symbols by what they are called.
using Indices = std::map<std::string, uint32_t, std::less<>>;

/// A state, profile or route with the names that are its own.
struct SymbolBody {
  support::SourceRange where;
  std::optional<uint32_t> owner;  ///< its index; none: the mission may not use it
  bool isolated = false;          ///< it sees no name of the mission
  Indices names;
};

/// What names mean: states, profiles and routes, functions, commands and values are named apart.
class Meanings {
 public:
  /// Of two with one name, that which is entered first is meant.
  void enter(const Symbol& symbol, uint32_t index);
  /// The index of what `name` means; `body`: where it stands; null: in none.
  [[nodiscard]] std::optional<uint32_t> find(Naming naming, std::string_view name,
                                             const SymbolBody* body) const;

 private:
  static constexpr size_t kKinds = static_cast<size_t>(SymbolKind::Command) + 1;
  /// Of all with that name that are of one of `kinds`, the one with the least index.
  [[nodiscard]] std::optional<uint32_t> first(std::initializer_list<SymbolKind> kinds,
                                              std::string_view name) const;

  std::array<Indices, kKinds> names_;
};

}  // namespace glider::frontend
