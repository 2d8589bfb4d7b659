// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/run_of_rules.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// A rule with a fresh copy of its unknowns.
class Taken {
 public:
  Taken(z3::context& context, const Rule& rule, size_t place)
      : rule_(rule), from_(context), to_(context) {
    for (const z3::expr& unknown : rule.unknowns) {
      const std::string name = fmt::format("{}@{}", unknown.decl().name().str(), place);
      from_.push_back(unknown);
      to_.push_back(context.constant(name.c_str(), unknown.get_sort()));
    }
  }

  z3::expr operator()(z3::expr term) const { return term.substitute(from_, to_); }
  [[nodiscard]] const Rule& rule() const { return rule_; }

 private:
  const Rule& rule_;
  z3::expr_vector from_;
  z3::expr_vector to_;
};

double valueOf(const z3::model& model, const Taken& taken, const NumberTerm& term) {
  return holds(model, taken(term.known)) ? doubleOf(model, taken(term.value)) : kNotKnown;
}

class Reading {
 public:
  Reading(const ProofContext& proof_context, const z3::model& model)
      : m_(proof_context.mission), model_(model) {}

  Step step(const Taken& taken) const {
    const Rule& rule = taken.rule();
    const Configuration& at = rule.after ? *rule.after : *rule.before;
    Step step;
    step.after = at.control;
    step.mission_time = doubleOf(model_, taken(at.mission_time));
    step.readings.assign(m_.sensors.size(), kNotKnown);
    for (const auto& [sensor, term] : rule.readings) {
      step.readings[sensor] = valueOf(model_, taken, term);
    }
    const Configuration& seen = rule.before ? *rule.before : at;
    if (seen.store.vehicle) {
      step.depth = doubleOf(model_, taken(seen.store.vehicle->depth));
    }
    return step;
  }

  std::vector<double> parameters(const Taken& start) const {
    std::vector<double> values;
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      if (m_.variables[i].kind == VariableKind::Parameter) {
        values.push_back(parameter(start, i));
      }
    }
    return values;
  }

 private:
  /// A parameter outside the cone of influence has its default.
  double parameter(const Taken& start, uint32_t index) const {
    const Store& store = start.rule().after->store;
    if (const auto number = store.numbers.find(index); number != store.numbers.end()) {
      return doubleOf(model_, start(number->second.value));
    }
    if (const auto truth = store.truths.find(index); truth != store.truths.end()) {
      return holds(model_, start(truth->second.is_true)) ? 1 : 0;
    }
    const Expr& initial = m_[m_.variables[index].initial];
    return initial.op == Op::Constant ? initial.number : initial.op == Op::True ? 1 : 0;
  }

  const Mission& m_;
  const z3::model& model_;
};

}  // namespace

std::optional<Run> runOfRules(z3::context& context, const ProofContext& proof_context,
                              const std::vector<Rule>& rules, const std::vector<size_t>& trace,
                              unsigned effort) {
  if (trace.empty() || rules[trace.front()].from) {
    return std::nullopt;
  }
  Question question(context, effort);
  std::vector<Taken> steps;
  for (size_t i = 0; i < trace.size(); ++i) {
    const Taken& taken = steps.emplace_back(context, rules[trace[i]], i);
    question.add(taken(taken.rule().condition));
    for (size_t k = 0; i > 0 && k < taken.rule().from_row.size(); ++k) {
      const Taken& before = steps[i - 1];
      question.add(taken(taken.rule().from_row[k]) == before(before.rule().to_row.at(k)));
    }
  }
  if (question.ask() != Answer::Yes) {
    return std::nullopt;
  }
  const z3::model model = question.model();
  const Reading reading(proof_context, model);
  Run run;
  run.parameters = reading.parameters(steps.front());
  for (const Taken& taken : steps) {
    if (taken.rule().tick) {
      run.steps.push_back(reading.step(taken));
    }
  }
  return run;
}

}  // namespace glider::ir::prove
