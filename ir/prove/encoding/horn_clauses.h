// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/chc_encoder.h"

#include <map>
#include <vector>

namespace glider::ir::prove {

/// Rules as formulas over one relation for each place.
class HornClauses {
 public:
  /// All must outlive this.
  HornClauses(z3::context& context, const std::vector<Rule>& rules);

  /// The relation of a place: which terms it takes follows from the place.
  [[nodiscard]] const std::map<Place, z3::func_decl>& relations() const { return relations_; }
  /// What a rule says: where its condition holds, one of its place's relation follows, or `bad`.
  [[nodiscard]] z3::expr clause(const Rule& rule, const z3::expr& bad) const;

 private:
  void add(const Place& place, const std::vector<z3::expr>& row);
  [[nodiscard]] z3::expr apply(const Place& place, const std::vector<z3::expr>& row) const;

  z3::context& context_;
  std::map<Place, z3::func_decl> relations_;
};

}  // namespace glider::ir::prove
