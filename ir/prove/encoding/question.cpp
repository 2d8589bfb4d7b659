// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/question.h"

#include "ir/core/pilot_name.h"
#include "ir/prove/context/duration_text.h"
#include "ir/verify/value_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {

Question::Question(z3::context& context, unsigned effort)
    : context_(context), solver_(context, z3::solver::simple()), assumptions_(context) {
  z3::params parameters(context);
  parameters.set("rlimit", effort);
  solver_.set(parameters);
}

Question::Question(z3::context& context, Budget& budget, unsigned effort)
    : Question(context, budget.allow(effort)) {
  budget_ = &budget;
}

/// Z3 counts the steps of all questions of a context together.
z3::check_result Question::check() {
  if (budget_ == nullptr) {
    return solver_.check(assumptions_);
  }
  budget_->spend(Budget::kQuestion + Budget::kCondition * conditions_);
  if (budget_->isUsedUp()) {
    return z3::unknown;
  }
  if (const auto limit = budget_->milliseconds()) {
    solver_.set("timeout", *limit);
  }
  const uint64_t before = stepsIn(solver_.statistics());
  const z3::check_result result = solver_.check(assumptions_);
  const uint64_t after = stepsIn(solver_.statistics());
  budget_->spend(after - std::min(before, after));
  return result;
}

void Question::assume(const z3::expr& holds) {
  const std::string name = fmt::format("assume!{}", assumptions_.size());
  const z3::expr assumption = context_.bool_const(name.c_str());
  solver_.add(z3::implies(assumption, holds));
  assumptions_.push_back(assumption);
  ++conditions_;
}

void Question::add(const Unknowns& unknowns) {
  for (const Fact& fact : unknowns.facts()) {
    if (fact.from == Fact::From::Nature) {
      add(fact.holds);
      continue;
    }
    assume(fact.holds);
    facts_.emplace_back(fact);
    names_.emplace_back(std::nullopt);
  }
}

void Question::add(const z3::expr& holds, uint32_t name) {
  assume(holds);
  facts_.emplace_back(std::nullopt);
  names_.emplace_back(name);
}

Answer Question::ask() {
  const z3::check_result result = check();
  if (result != z3::unsat) {
    return result == z3::sat ? Answer::Yes : Answer::Unknown;
  }
  for (const z3::expr& needed : solver_.unsat_core()) {
    size_t i = 0;
    for (const z3::expr& assumption : assumptions_) {
      if (z3::eq(assumption, needed) && facts_[i]) {
        needed_facts_.push_back(*facts_[i]);
      } else if (z3::eq(assumption, needed)) {
        needed_names_.push_back(*names_[i]);
      }
      ++i;
    }
  }
  return Answer::No;
}

uint64_t stepsIn(const z3::stats& statistics) {
  for (unsigned i = 0; i < statistics.size(); ++i) {
    if (statistics.key(i) == "rlimit count") {
      return statistics.uint_value(i);
    }
  }
  return 0;
}

namespace {

/// Long times as pilots say them, where that says all.
std::string momentOf(double seconds) {
  constexpr double kLong_s = 3600;
  return seconds >= kLong_s && seconds == std::floor(seconds) ? durationOf(seconds)
                                                              : fmt::format("{:.6g} s", seconds);
}

class Description {
 public:
  Description(const z3::model& model, SymbolicState& moment) : model_(model), moment_(moment) {}

  std::string run() {
    const Mission& m = moment_.mission();
    for (const auto& [index, term] : moment_.readings()) {
      if (m.compass && m.compass->variation == SensorId{index}) {
        continue;  // the runtime's own: it makes headings true
      }
      number(m.sensors[index].name, term,
             [&](double value) { return moment_.proof_context().readingText({index}, value); });
    }
    for (const auto& [index, term] : moment_.numbers()) {
      if (!isInner(m, {index})) {
        number(pilotName(m, {index}), term,
               [&](double value) { return withUnit(value, m.variables[index]); });
      }
    }
    for (const auto& [index, term] : moment_.truths()) {
      if (!isInner(m, {index})) {
        add(pilotName(m, {index}), holds(model_, term.is_true)    ? "= true"
                                   : holds(model_, term.is_false) ? "= false"
                                                                  : "unknown");
      }
    }
    for (const auto& [name, clock] : moment_.clocks()) {
      add(name, "= " + momentOf(doubleOf(model_, clock)));
    }
    return text_;
  }

 private:
  template <typename Text>
  void number(const std::string& name, const NumberTerm& term, const Text& text) {
    add(name, holds(model_, term.known) ? "= " + text(doubleOf(model_, term.value)) : "unknown");
  }
  void add(std::string_view name, std::string_view value) {
    text_ += fmt::format("{}{} {}", text_.empty() ? "" : ", ", name, value);
  }

  const z3::model& model_;
  SymbolicState& moment_;
  std::string text_;
};

}  // namespace

std::string describe(const z3::model& model, SymbolicState& moment) {
  return Description(model, moment).run();
}

}  // namespace glider::ir::prove
