// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/horn_clauses.h"

#include <fmt/format.h>

namespace glider::ir::prove {

HornClauses::HornClauses(z3::context& context, const std::vector<Rule>& rules) : context_(context) {
  for (const Rule& rule : rules) {
    if (rule.from) {
      add(*rule.from, rule.from_row);
    }
    if (rule.to) {
      add(*rule.to, rule.to_row);
    }
  }
}

void HornClauses::add(const Place& place, const std::vector<z3::expr>& row) {
  if (relations_.contains(place)) {
    return;
  }
  z3::sort_vector sorts(context_);
  for (const z3::expr& term : row) {
    sorts.push_back(term.get_sort());
  }
  const std::string name =
      fmt::format("{}{}", place.side == Side::Due ? "due" : "done", relations_.size());
  relations_.emplace(place, context_.function(name.c_str(), sorts, context_.bool_sort()));
}

z3::expr HornClauses::apply(const Place& place, const std::vector<z3::expr>& row) const {
  z3::expr_vector arguments(context_);
  for (const z3::expr& term : row) {
    arguments.push_back(term);
  }
  return relations_.at(place)(arguments);
}

z3::expr HornClauses::clause(const Rule& rule, const z3::expr& bad) const {
  z3::expr body = rule.condition;
  if (rule.from) {
    body = apply(*rule.from, rule.from_row) && body;
  }
  const z3::expr clause = z3::implies(body, rule.to ? apply(*rule.to, rule.to_row) : bad);
  if (rule.unknowns.empty()) {
    return clause;
  }
  z3::expr_vector bound(context_);
  for (const z3::expr& unknown : rule.unknowns) {
    bound.push_back(unknown);
  }
  return z3::forall(bound, clause);
}

}  // namespace glider::ir::prove
