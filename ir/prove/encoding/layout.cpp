// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/layout.h"

#include "ir/certify/names.h"
#include "ir/core/ops.h"
#include "ir/verify/intervals.h"

#include <cmath>

namespace glider::ir::prove {
namespace {

/// Z3 puts a symbol in bars where it must.
std::string unquoted(const std::string& name) {
  return name.substr(1, name.size() - 2);
}

/// The declared range, which every value that is known has.
void requireRange(const Variable& variable, const z3::expr& value, Unknowns& unknowns) {
  z3::context& context = value.ctx();
  if (variable.lowest > -kGreatestNumber) {
    unknowns.require(value >= realOf(context, variable.lowest));
  }
  if (variable.highest < kGreatestNumber) {
    unknowns.require(value <= realOf(context, variable.highest));
  }
}

}  // namespace

bool Layout::keeps(const Control& control, uint32_t variable) const {
  const Variable& v = m_.variables[variable];
  return relevance_.variables[variable] && v.kind != VariableKind::Momentary &&
         !isFree(control, variable) && (!v.owner.valid() || control.holds(v.owner));
}

bool Layout::watches(const Control& control, uint32_t temporal) const {
  const Temporal& t = m_.temporals[temporal];
  return follows(control) && !isWindow(t.kind) && relevance_.temporals[temporal] &&
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
    const bool kept = keeps(control, i) || isFree(control, i);
    const z3::expr never = context.bool_val(false);
    if (m_.variables[i].type.kind == TypeKind::Bool) {
      result.store.truths.emplace(i,
                                  kept ? TruthTerm{unknowns.truth("true"), unknowns.truth("false")}
                                       : TruthTerm{never, never});
      if (isFree(control, i)) {
        const TruthTerm& free = result.store.truths.at(i);
        unknowns.require(!(free.is_true && free.is_false));
      }
    } else {
      const z3::expr known = !kept                               ? never
                             : proof_context_.known.variables[i] ? context.bool_val(true)
                                                                 : unknowns.truth("known");
      const z3::expr value = kept ? unknowns.real("v") : nothing;
      result.store.numbers.emplace(i, NumberTerm{value, known, 0});
      if (isFree(control, i)) {
        requireRange(m_.variables[i], value, unknowns);
      }
    }
  }
  for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
    if (watches(control, i)) {
      result.watched.emplace(i, Watched{unknowns.truth("was"), unknowns.real("since")});
    }
  }
  if (relevance_.vehicle) {
    result.store.vehicle =
        scope_ != nullptr
            ? vehicleWithin(control, unknowns)
            : Vehicle{unknowns.real("depth"), unknowns.real("deepest"), unknowns.truth("climbing"),
                      unknowns.real("climbing since"), unknowns.real("top")};
  }
  for (const MemoryTerm& term : memory_) {
    result.memory.push_back(term.sort.is_bool() ? unknowns.truth("memory")
                                                : unknowns.real("memory"));
  }
  return result;
}

/// One that climbs is as deep as it may have been, so that its rules hold for every other.
Vehicle Layout::vehicleWithin(const Control& control, Unknowns& unknowns) const {
  z3::context& context = unknowns.context();
  const bool climbs = scope_->climbs(control);
  const double deepest =
      follows(control) ? scope_->bounds[control.state.index].depth : scope_->deepest;
  const z3::expr depth = unknowns.real("depth");
  unknowns.require(depth >= 0);
  const z3::expr bound =
      std::isfinite(deepest) ? realOf(context, deepest) : unknowns.real("deepest");
  unknowns.require(depth <= bound);
  return {depth, bound, context.bool_val(climbs),
          climbs ? unknowns.real("climbing since") : context.real_val(0), context.real_val(0)};
}

std::vector<std::string> Layout::names(const Control& control) const {
  std::vector<std::string> all{"time"};
  const bool followed = follows(control);
  for (size_t i = 0; followed && relevance_.state_time && i <= control.stack.size(); ++i) {
    all.push_back(unquoted(certify::enteredName(i)));
  }
  if (followed && relevance_.resume_time) {
    all.emplace_back("resumed");
  }
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    if (!relevance_.variables[i] || !keeps(control, i)) {
      continue;
    }
    const Variable& variable = m_.variables[i];
    const bool truth = variable.type.kind == TypeKind::Bool;
    all.push_back(unquoted(certify::variableName(variable, truth ? " true" : "")));
    if (truth || !proof_context_.known.variables[i]) {
      all.push_back(unquoted(certify::variableName(variable, truth ? " false" : " known")));
    }
  }
  for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
    if (watches(control, i)) {
      all.push_back(unquoted(certify::temporalName("was", i)));
      all.push_back(unquoted(certify::temporalName("since", i)));
    }
  }
  if (followed && relevance_.vehicle && scope_ != nullptr) {
    all.emplace_back("depth");
    if (scope_->climbs(control)) {
      all.emplace_back("climbing since");
    }
  } else if (relevance_.vehicle && scope_ == nullptr) {
    all.insert(all.end(), {"depth", "deepest", "climbing", "climbing since", "top"});
  }
  for (const MemoryTerm& term : memory_) {
    all.push_back(term.name);
  }
  return all;
}

z3::expr Layout::known(const Control& control, z3::context& context) const {
  z3::expr all = context.bool_val(true);
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    const Variable& variable = m_.variables[i];
    if (relevance_.variables[i] && keeps(control, i) && proof_context_.known.variables[i] &&
        variable.type.kind != TypeKind::Bool) {
      const std::string name = unquoted(certify::variableName(variable, " known"));
      all = all && context.bool_const(name.c_str());
    }
  }
  return all;
}

std::vector<z3::expr> Layout::row(const Configuration& c) const {
  std::vector<z3::expr> row{c.mission_time};
  const bool followed = follows(c.control);
  if (followed && relevance_.state_time) {
    row.insert(row.end(), c.entered.begin(), c.entered.end());
  }
  if (followed && relevance_.resume_time) {
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
  if (followed && relevance_.vehicle && scope_ != nullptr) {
    row.push_back(c.store.vehicle->depth);
    if (scope_->climbs(c.control)) {
      row.push_back(c.store.vehicle->since);
    }
  } else if (relevance_.vehicle && scope_ == nullptr) {
    const Vehicle& v = *c.store.vehicle;
    row.insert(row.end(), {v.depth, v.deepest, v.climbing, v.since, v.top});
  }
  row.insert(row.end(), c.memory.begin(), c.memory.end());
  return row;
}

}  // namespace glider::ir::prove
