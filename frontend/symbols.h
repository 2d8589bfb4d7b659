// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/frontend.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The meanings of a mission's names, for editors. Also available for a mission with errors: what
/// has an error has an unknown type.
namespace glider::frontend {

enum class SymbolKind : uint8_t {
  Mission,
  Platform,
  Constant,
  Parameter,  ///< of the mission; with an owner: of that state, profile or route
  Variable,   ///< the same
  State,
  Profile,
  Route,
  Sensor,
  Clock,
  Condition,  ///< `profiledone`, `routedone`
  Function,
  Command
};
/// "constant"
std::string_view word(SymbolKind kind);

struct Symbol {
  SymbolKind kind = SymbolKind::Mission;
  std::string name;
  std::string vehicle_name;  ///< of a sensor that has another name in the language: "m_depth"
  /// As a pilot writes it: "length"; with parameters "yo(top: length, …)". Empty: unknown.
  std::string type;
  std::string unit;            ///< of a bare number of that type; empty: none
  std::string description;     ///< one line: its comment, or else its declaration
  support::SourceRange where;  ///< its name in its declaration; empty: it is built in
  /// The only place where it can be used; empty: in every file. Profiles and routes cannot use
  /// constants, parameters, variables or states of the mission.
  support::SourceRange scope;
  std::optional<uint32_t> owner;           ///< index of the state, profile or route it belongs to
  std::vector<support::SourceRange> uses;  ///< by file and position
};

/// The names of a mission and its imports, its platform and the language.
class SymbolTable {
 public:
  /// `isolated`: the profiles and routes in the text.
  SymbolTable(std::vector<Symbol> symbols, std::vector<support::SourceRange> isolated);

  /// Those of the mission's text first, in its order, then those of the libraries, then the others.
  [[nodiscard]] std::span<const Symbol> symbols() const { return symbols_; }
  /// The meaning of the name at byte `offset`, or that ends there; null: there is no known name.
  [[nodiscard]] const Symbol* at(uint32_t file, uint32_t offset) const;
  /// The symbols that can be named at byte `offset`.
  [[nodiscard]] std::vector<const Symbol*> visibleAt(uint32_t file, uint32_t offset) const;

 private:
  struct Place {
    support::SourceRange range;
    uint32_t symbol = 0;
  };
  std::vector<Symbol> symbols_;
  std::vector<support::SourceRange> isolated_;
  std::vector<Place> places_;  ///< of all names, by file and position
};

/// The names of `mission` and of `inputs.library`, each of which may be the result of parseIntact.
/// Reports nothing.
SymbolTable symbolsOf(const ast::File& mission, const AnalysisInputs& inputs);

}  // namespace glider::frontend
