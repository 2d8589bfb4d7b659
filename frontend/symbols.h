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

/// What the names of a mission mean, for editors. It is there for a mission with errors, too: what
/// is broken has an unknown type.
namespace glider::frontend {

enum class SymbolKind : uint8_t {
  Mission,
  Platform,
  Constant,
  Parameter,  ///< of the mission; with an owner: of that state, profile or route
  Variable,   ///< likewise
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
  std::string vehicle_name;  ///< of a sensor that the language calls by another name: "m_depth"
  /// As a pilot writes it: "length"; of what takes arguments "yo(top: length, …)". Empty: unknown.
  std::string type;
  std::string unit;            ///< of a bare number of that type; empty: none
  std::string description;     ///< one line: its comment, or else its declaration
  support::SourceRange where;  ///< its name in its declaration; nowhere: it is built in
  /// Where alone it can be used; nowhere: in every file. Profiles and routes see no constant,
  /// parameter, variable or state of the mission.
  support::SourceRange scope;
  std::optional<uint32_t> owner;           ///< index of the state, profile or route it belongs to
  std::vector<support::SourceRange> uses;  ///< by file and position
};

/// The names of a mission and of what it imports, its platform and the language.
class SymbolTable {
 public:
  /// `isolated`: the profiles and routes in the text.
  SymbolTable(std::vector<Symbol> symbols, std::vector<support::SourceRange> isolated);

  /// Those of the mission's text first, in its order, then those of the libraries, then the others.
  [[nodiscard]] std::span<const Symbol> symbols() const { return symbols_; }
  /// What the name means that stands at or ends at byte `offset`; null: no known name does.
  [[nodiscard]] const Symbol* at(uint32_t file, uint32_t offset) const;
  /// What can be named at byte `offset`.
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

/// The names of `mission` and of `inputs.library`; any of them may be what parseIntact has left.
/// Reports nothing.
SymbolTable symbolsOf(const ast::File& mission, const AnalysisInputs& inputs);

}  // namespace glider::frontend
