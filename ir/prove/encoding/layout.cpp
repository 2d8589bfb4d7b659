// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/layout.h"

#include "ir/core/ops.h"

namespace glider::ir::prove {

bool Layout::keeps(const Control& control, uint32_t variable) const {
  const Variable& v = m_.variables[variable];
  return relevance_.variables[variable] && (!v.owner.valid() || control.holds(v.owner));
}

bool Layout::watches(const Control& control, uint32_t temporal) const {
  const Temporal& t = m_.temporals[temporal];
  return !isWindow(t.kind) && relevance_.temporals[temporal] &&
         (t.list == ListKind::Always || t.state == control.state);
}

/// Every variable in the cone of influence has a term, so that a state that is entered can set the
/// terms of its own variables; a variable that is not kept is never read before it starts.
Configuration Layout::make(const Control& control, Unknowns& unknowns) const {
  z3::context& context = unknowns.context();
  const z3::expr nothing = context.real_val(0);
  Configuration result{control, unknowns.real("m"), {}, nothing, {}, {}, {}};
  for (size_t i = 0; i <= control.stack.size(); ++i) {
    result.entered.push_back(relevance_.state_time ? unknowns.real("entered") : nothing);
  }
  result.resumed = relevance_.resume_time ? unknowns.real("resumed") : nothing;
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    if (!relevance_.variables[i]) {
      continue;
    }
    const bool kept = keeps(control, i);
    const z3::expr never = context.bool_val(false);
    if (m_.variables[i].type.kind == TypeKind::Bool) {
      result.store.truths.emplace(i,
                                  kept ? TruthTerm{unknowns.truth("true"), unknowns.truth("false")}
                                       : TruthTerm{never, never});
    } else {
      const z3::expr known = !kept                               ? never
                             : proof_context_.known.variables[i] ? context.bool_val(true)
                                                                 : unknowns.truth("known");
      result.store.numbers.emplace(i, NumberTerm{kept ? unknowns.real("v") : nothing, known, 0});
    }
  }
  for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
    if (watches(control, i)) {
      result.watched.emplace(i, Watched{unknowns.truth("was"), unknowns.real("since")});
    }
  }
  if (relevance_.vehicle) {
    result.store.vehicle =
        Vehicle{unknowns.real("depth"), unknowns.real("deepest"), unknowns.truth("climbing"),
                unknowns.real("climbing since"), unknowns.real("top")};
  }
  for (const z3::sort& sort : memory_) {
    result.memory.push_back(sort.is_bool() ? unknowns.truth("memory") : unknowns.real("memory"));
  }
  return result;
}

std::vector<z3::expr> Layout::row(const Configuration& c) const {
  std::vector<z3::expr> row{c.mission_time};
  if (relevance_.state_time) {
    row.insert(row.end(), c.entered.begin(), c.entered.end());
  }
  if (relevance_.resume_time) {
    row.push_back(c.resumed);
  }
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    if (!relevance_.variables[i] || !keeps(c.control, i)) {
      continue;
    }
    if (m_.variables[i].type.kind == TypeKind::Bool) {
      row.push_back(c.store.truths.at(i).is_true);
      row.push_back(c.store.truths.at(i).is_false);
      continue;
    }
    row.push_back(c.store.numbers.at(i).value);
    if (!proof_context_.known.variables[i]) {
      row.push_back(c.store.numbers.at(i).known);
    }
  }
  for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
    if (watches(c.control, i)) {
      row.push_back(c.watched.at(i).was_true);
      row.push_back(c.watched.at(i).since);
    }
  }
  if (relevance_.vehicle) {
    const Vehicle& v = *c.store.vehicle;
    row.insert(row.end(), {v.depth, v.deepest, v.climbing, v.since, v.top});
  }
  row.insert(row.end(), c.memory.begin(), c.memory.end());
  return row;
}

}  // namespace glider::ir::prove
