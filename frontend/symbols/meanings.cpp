// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/symbols/meanings.h"

#include <algorithm>

namespace glider::frontend {

void Meanings::enter(const Symbol& symbol, uint32_t index) {
  Indices& names = names_[static_cast<size_t>(symbol.kind)];
  names.emplace(symbol.name, index);
  if (!symbol.vehicle_name.empty()) {
    names.emplace(symbol.vehicle_name, index);
  }
}

std::optional<uint32_t> Meanings::first(std::initializer_list<SymbolKind> kinds,
                                        std::string_view name) const {
  std::optional<uint32_t> best;
  for (const SymbolKind kind : kinds) {
    const Indices& names = names_[static_cast<size_t>(kind)];
    if (const auto found = names.find(name); found != names.end()) {
      best = std::min(best.value_or(UINT32_MAX), found->second);
    }
  }
  return best;
}

std::optional<uint32_t> Meanings::find(Naming naming, std::string_view name,
                                       const SymbolBody* body) const {
  switch (naming) {
    case Naming::State:
      return first({SymbolKind::State}, name);
    case Naming::Behaviour:
      return first({SymbolKind::Profile, SymbolKind::Route}, name);
    case Naming::Platform:
      return first({SymbolKind::Platform}, name);
    case Naming::Command:
      return first({SymbolKind::Command}, name);
    case Naming::Function:
      return first({SymbolKind::Function}, name);
    case Naming::Value:
      break;
  }
  if (body != nullptr) {
    if (const auto own = body->names.find(name); own != body->names.end()) {
      return own->second;
    }
  }
  const bool isolated = body != nullptr && body->isolated;
  const auto mission =
      first({SymbolKind::Constant, SymbolKind::Parameter, SymbolKind::Variable}, name);
  return mission && !isolated
             ? mission
             : first({SymbolKind::Sensor, SymbolKind::Clock, SymbolKind::Condition}, name);
}

}  // namespace glider::frontend
