// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/certify/between.h"

#include "ir/certify/names.h"
#include "ir/core/ops.h"

#include <unordered_map>

namespace glider::ir::certify {
namespace {

Value namedVariable(const Variable& v) {
  if (v.type.kind == TypeKind::Bool) {
    return Truths{variableName(v, " true"), variableName(v, " false")};
  }
  return Number{variableName(v, ""), variableName(v, " known")};
}

using Terms = std::unordered_map<std::string, Term>;

void addVariables(const Mission& mission, const Store& store, Terms& terms) {
  for (uint32_t i = 0; i < mission.variables.size(); ++i) {
    const Variable& v = mission.variables[i];
    if (const auto* n = std::get_if<Number>(&store.variables[i])) {
      terms[variableName(v, "")] = n->value;
      terms[variableName(v, " known")] = n->known;
    } else {
      const auto& t = std::get<Truths>(store.variables[i]);
      terms[variableName(v, " true")] = t.is_true;
      terms[variableName(v, " false")] = t.is_false;
    }
  }
}

Terms termsOf(const Mission& mission, const Between& between) {
  const Vehicle& v = between.store.vehicle;
  Terms terms{{"|time|", between.time},
              {"|resumed|", between.store.resumed},
              {"|depth|", v.depth},
              {"|deepest|", v.deepest},
              {"|climbing|", v.climbing},
              {"|climbing since|", v.since},
              {"|top|", v.top},
              {"|after seen|", between.remembered.after_seen},
              {"|surfaced|", between.remembered.surfaced}};
  for (size_t k = 0; k < between.store.entered.size(); ++k) {
    terms[enteredName(k)] = between.store.entered[k];
  }
  for (uint32_t i = 0; i < mission.temporals.size(); ++i) {
    terms[temporalName("was", i)] = between.store.memory[i].was;
    terms[temporalName("since", i)] = between.store.memory[i].since;
  }
  addVariables(mission, between.store, terms);
  return terms;
}

Term bothTrueAndFalse(const Value& value) {
  const auto* t = std::get_if<Truths>(&value);
  return t == nullptr ? Term("false") : conjunction({t->is_true, t->is_false});
}

}  // namespace

Store emptyStore(const Mission& mission) {
  Store store;
  for (const Variable& v : mission.variables) {
    store.variables.push_back(v.type.kind == TypeKind::Bool ? Value(Truths()) : Value(Number()));
  }
  for (const Temporal& t : mission.temporals) {
    store.memory.emplace_back();
    store.temporals.push_back(isWindow(t.kind) ? Value(Number()) : Value(Truths()));
  }
  return store;
}

Between namedIn(const Setting& setting, const Configuration& at) {
  const Mission& mission = setting.mission;
  Between named{emptyStore(mission), "|time|", {}};
  for (size_t k = 0; k <= at.stack.size(); ++k) {
    named.store.entered.push_back(enteredName(k));
  }
  named.store.resumed = "|resumed|";
  for (uint32_t i = 0; i < mission.variables.size(); ++i) {
    if (hasStarted(mission.variables[i], at)) {
      named.store.variables[i] = namedVariable(mission.variables[i]);
    }
  }
  for (uint32_t i = 0; i < mission.temporals.size(); ++i) {
    if (isRemembered(mission.temporals[i], at.state)) {
      named.store.memory[i] = {temporalName("was", i), temporalName("since", i)};
    }
  }
  named.store.vehicle = {"|depth|", "|deepest|", "|climbing|", "|climbing since|", "|top|"};
  if (setting.requirement.kind == RequirementKind::NeverAfter) {
    named.remembered.after_seen = "|after seen|";
  } else if (setting.requirement.kind == RequirementKind::SurfacesEvery) {
    named.remembered.surfaced = "|surfaced|";
  }
  return named;
}

std::vector<Term> valuesOf(const Setting& setting, const Configuration& at,
                           const Between& between) {
  const Terms terms = termsOf(setting.mission, between);
  std::vector<Term> values;
  for (const Name& name : namesIn(setting.mission, setting.requirement, at)) {
    values.push_back(terms.at(name.text));
  }
  return values;
}

Term wellFormed(const Setting& setting, const Configuration& at, const Between& between) {
  const Store& store = between.store;
  std::vector<Term> clocks{"0.0"};
  clocks.insert(clocks.end(), store.entered.begin(), store.entered.end());
  clocks.insert(clocks.end(), {store.resumed, between.time});
  std::vector<Term> all{operation("<=", clocks),
                        operation("<=", {"0.0", store.vehicle.depth, store.vehicle.deepest}),
                        operation("<=", {"0.0", between.remembered.surfaced, between.time})};
  for (uint32_t i = 0; i < setting.mission.temporals.size(); ++i) {
    const Temporal& t = setting.mission.temporals[i];
    if (isRemembered(t, at.state)) {
      const Term start = t.list == ListKind::Always ? Term("0.0") : store.resumed;
      all.push_back(operation("<=", {start, store.memory[i].since, between.time}));
    }
  }
  for (uint32_t i = 0; i < setting.mission.variables.size(); ++i) {
    if (hasStarted(setting.mission.variables[i], at)) {
      all.push_back(negation(bothTrueAndFalse(store.variables[i])));
    }
  }
  return conjunction(all);
}

void requireRanges(const Setting& setting, SmtText& out, const Configuration& at,
                   const Store& store) {
  for (uint32_t i = 0; i < setting.mission.variables.size(); ++i) {
    const Variable& v = setting.mission.variables[i];
    if (!hasStarted(v, at)) {
      continue;
    }
    const bool parameter = v.kind == VariableKind::Parameter;
    const auto* n = std::get_if<Number>(&store.variables[i]);
    if (n == nullptr) {
      const auto& t = std::get<Truths>(store.variables[i]);
      out.require(parameter ? disjunction({t.is_true, t.is_false}) : Term("true"));
      continue;
    }
    const Range& range = setting.facts.declared[i];
    out.require(parameter ? n->known : Term("true"));
    out.require(implication(
        n->known, operation("<=", {literal(range.lowest), n->value, literal(range.highest)})));
    if (setting.facts.whole_variable[i]) {
      out.require(implication(
          n->known, operation("=", {n->value, operation("to_real", {out.fresh("Int")})})));
    }
  }
}

}  // namespace glider::ir::certify
