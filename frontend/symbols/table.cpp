// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The queries of a symbol table.

#include "frontend/symbols.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace glider::frontend {
namespace {

/// Including the end: an editor's cursor is after the word that was typed.
bool touches(const support::SourceRange& range, uint32_t file, uint32_t offset) {
  return range.file == file && range.begin <= offset && offset <= range.end;
}

bool isOfMission(SymbolKind kind) {
  return kind == SymbolKind::Mission || kind == SymbolKind::Constant ||
         kind == SymbolKind::Parameter || kind == SymbolKind::Variable || kind == SymbolKind::State;
}

}  // namespace

std::string_view word(SymbolKind kind) {
  constexpr std::string_view kWords[] = {
      "mission", "platform", "constant", "parameter", "variable", "state",  "profile",
      "route",   "sensor",   "clock",    "condition", "function", "command"};
  return kWords[static_cast<size_t>(kind)];
}

SymbolTable::SymbolTable(std::vector<Symbol> symbols, std::vector<support::SourceRange> isolated)
    : symbols_(std::move(symbols)), isolated_(std::move(isolated)) {
  for (uint32_t i = 0; i < symbols_.size(); ++i) {
    if (symbols_[i].where.valid()) {
      places_.push_back({symbols_[i].where, i});
    }
    for (const support::SourceRange& use : symbols_[i].uses) {
      places_.push_back({use, i});
    }
  }
  std::ranges::sort(places_, {}, [](const Place& place) {
    return std::tuple(place.range.file, place.range.begin);
  });
}

const Symbol* SymbolTable::at(uint32_t file, uint32_t offset) const {
  auto after = std::ranges::upper_bound(
      places_, std::pair(file, offset), {},
      [](const Place& place) { return std::pair(place.range.file, place.range.begin); });
  // The last name that begins there or before: names do not overlap.
  if (after == places_.begin() || !touches(std::prev(after)->range, file, offset)) {
    return nullptr;
  }
  return &symbols_[std::prev(after)->symbol];
}

std::vector<const Symbol*> SymbolTable::visibleAt(uint32_t file, uint32_t offset) const {
  const bool isolated = std::ranges::any_of(
      isolated_, [&](const support::SourceRange& body) { return touches(body, file, offset); });
  std::vector<const Symbol*> visible;
  for (const Symbol& symbol : symbols_) {
    const bool local = symbol.scope.valid();
    if (local ? touches(symbol.scope, file, offset) : !isolated || !isOfMission(symbol.kind)) {
      visible.push_back(&symbol);
    }
  }
  return visible;
}

}  // namespace glider::frontend
