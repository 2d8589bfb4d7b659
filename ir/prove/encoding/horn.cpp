// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/horn.h"

#include "ir/prove/encoding/horn_clauses.h"
#include "ir/prove/encoding/run_of_rules.h"

#include <fmt/format.h>

#include <sstream>

namespace glider::ir::prove {
namespace {

/// Turns off the transformations of Spacer that fold rules into each other: the rules would lose
/// their names, and with them the trace.
void configure(z3::context& context, z3::fixedpoint& engine, Lemmas lemmas) {
  z3::params parameters(context);
  parameters.set("engine", context.str_symbol("spacer"));
  for (const char* option :
       {"xform.inline_eager", "xform.inline_linear", "xform.slice", "xform.tail_simplifier_pve"}) {
    parameters.set(option, false);
  }
  if (lemmas == Lemmas::Elimination) {
    constexpr unsigned kGauss = 2;
    parameters.set("spacer.iuc.arith", kGauss);
  }
  engine.set(parameters);
}

class Engine {
 public:
  Engine(z3::context& context, const std::vector<Rule>& rules, Lemmas lemmas)
      : context_(context),
        clauses_(context, rules),
        engine_(context),
        bad_(context.function("bad", 0, nullptr, context.bool_sort())) {
    configure(context, engine_, lemmas);
    engine_.register_relation(bad_);
    for (const auto& [place, relation] : clauses_.relations()) {
      z3::func_decl registered = relation;
      engine_.register_relation(registered);
    }
    for (size_t i = 0; i < rules.size(); ++i) {
      z3::expr clause = clauses_.clause(rules[i], bad_());
      engine_.add_rule(clause, context_.str_symbol(fmt::format("{}{}", kPrefix, i).c_str()));
    }
  }

  z3::check_result ask() {
    z3::expr query = bad_();
    return engine_.query(query);
  }

  /// After sat: the numbers of the rules that the bad trace used, the start first.
  std::vector<size_t> trace() {
    const Z3_symbol names = Z3_fixedpoint_get_rule_names_along_trace(context_, engine_);
    std::istringstream in(Z3_get_symbol_string(context_, names));
    std::vector<size_t> numbers;
    for (std::string name; std::getline(in, name, ';');) {
      if (name.starts_with(kPrefix)) {
        numbers.push_back(std::stoul(name.substr(kPrefix.size())));
      }
    }
    return {numbers.rbegin(), numbers.rend()};
  }

  /// After unsat: what holds at every place that a trace can come to, over these terms of its row.
  z3::expr invariant(const Place& place, const std::vector<std::string>& names) {
    z3::func_decl relation = clauses_.relations().at(place);
    z3::expr_vector terms(context_);
    for (unsigned i = 0; i < relation.arity(); ++i) {
      terms.push_back(context_.constant(names.at(i).c_str(), relation.domain(i)));
    }
    constexpr int kEveryTrace = -1;
    return engine_.get_cover_delta(kEveryTrace, relation).substitute(terms);
  }

  [[nodiscard]] const HornClauses& clauses() const { return clauses_; }
  uint64_t steps() { return stepsIn(engine_.statistics()); }

  std::string reason() { return engine_.reason_unknown(); }

 private:
  static constexpr std::string_view kPrefix = "rule";

  z3::context& context_;
  HornClauses clauses_;
  z3::fixedpoint engine_;
  z3::func_decl bad_;
};

std::vector<certify::Invariant> invariantsOf(z3::context& context, Engine& engine,
                                             const Layout& layout) {
  std::vector<certify::Invariant> all;
  for (const auto& [place, relation] : engine.clauses().relations()) {
    if (place.side == Side::Done) {
      const z3::expr holds = engine.invariant(place, layout.names(place.control)) &&
                             layout.known(place.control, context);
      all.push_back({configurationOf(place.control), holds.simplify().to_string()});
    }
  }
  return all;
}

}  // namespace

RunsAnswer askAboutRuns(z3::context& context, const ProofContext& proof_context,
                        const ConeOfInfluence& relevance, const SafetyProperty& watch,
                        unsigned effort, bool keep_invariants) {
  ChcEncoder writer(context, proof_context, relevance, watch);
  if (!writer.run()) {
    return {Answer::Unknown, std::nullopt, "the mission has too many call stacks",
            Budget::kRule * writer.rules().size()};
  }
  Engine engine(context, writer.rules(), watch.lemmas);
  const z3::check_result result = engine.ask();
  RunsAnswer answer;
  answer.steps = engine.steps() + Budget::kRule * writer.rules().size();
  if (result == z3::unknown) {
    answer.trouble = engine.reason();
    return answer;
  }
  if (result == z3::unsat) {
    answer.bad = Answer::No;
    if (keep_invariants) {
      answer.invariants = invariantsOf(context, engine, writer.layout());
    }
    return answer;
  }
  if (watch.scope) {
    answer.trouble = "what it does elsewhere may matter";
    return answer;
  }
  answer.run = runOfRules(context, proof_context, writer.rules(), engine.trace(), effort);
  answer.bad = answer.run ? Answer::Yes : Answer::Unknown;
  if (!answer.run) {
    answer.trouble = "a counterexample was found, but not all of its values";
  }
  return answer;
}

}  // namespace glider::ir::prove
