// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/horn.h"

#include "ir/prove/encoding/chc_encoder.h"
#include "ir/prove/encoding/run_of_rules.h"

#include <fmt/format.h>

#include <sstream>

namespace glider::ir::prove {
namespace {

/// Turns off the transformations of Spacer that fold rules into each other: the rules would lose
/// their names, and with them the trace.
void configure(z3::context& context, z3::fixedpoint& engine) {
  z3::params parameters(context);
  parameters.set("engine", context.str_symbol("spacer"));
  for (const char* option :
       {"xform.inline_eager", "xform.inline_linear", "xform.slice", "xform.tail_simplifier_pve"}) {
    parameters.set(option, false);
  }
  engine.set(parameters);
}

class Engine {
 public:
  Engine(z3::context& context, const std::vector<Rule>& rules)
      : context_(context), rules_(rules), engine_(context), bad_(bad(context)) {
    configure(context, engine_);
    engine_.register_relation(bad_);
    for (size_t i = 0; i < rules.size(); ++i) {
      add(rules[i], i);
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

  uint64_t steps() { return stepsIn(engine_.statistics()); }

  std::string reason() { return engine_.reason_unknown(); }

 private:
  static constexpr std::string_view kPrefix = "rule";

  static z3::func_decl bad(z3::context& context) {
    return context.function("bad", 0, nullptr, context.bool_sort());
  }

  z3::func_decl relation(const Place& place, const std::vector<z3::expr>& row) {
    const auto found = relations_.find(place);
    if (found != relations_.end()) {
      return found->second;
    }
    z3::sort_vector sorts(context_);
    for (const z3::expr& term : row) {
      sorts.push_back(term.get_sort());
    }
    const std::string name =
        fmt::format("{}{}", place.side == Side::Due ? "due" : "done", relations_.size());
    const z3::func_decl made = context_.function(name.c_str(), sorts, context_.bool_sort());
    z3::func_decl registered = made;
    engine_.register_relation(registered);
    return relations_.emplace(place, made).first->second;
  }

  z3::expr apply(const Place& place, const std::vector<z3::expr>& row) {
    z3::expr_vector arguments(context_);
    for (const z3::expr& term : row) {
      arguments.push_back(term);
    }
    return relation(place, row)(arguments);
  }

  void add(const Rule& rule, size_t number) {
    z3::expr body = rule.condition;
    if (rule.from) {
      body = apply(*rule.from, rule.from_row) && body;
    }
    z3::expr clause = z3::implies(body, rule.to ? apply(*rule.to, rule.to_row) : bad_());
    if (!rule.unknowns.empty()) {
      z3::expr_vector bound(context_);
      for (const z3::expr& unknown : rule.unknowns) {
        bound.push_back(unknown);
      }
      clause = z3::forall(bound, clause);
    }
    engine_.add_rule(clause, context_.str_symbol(fmt::format("{}{}", kPrefix, number).c_str()));
  }

  z3::context& context_;
  const std::vector<Rule>& rules_;
  z3::fixedpoint engine_;
  z3::func_decl bad_;
  std::map<Place, z3::func_decl> relations_;
};

}  // namespace

RunsAnswer askAboutRuns(z3::context& context, const ProofContext& proof_context,
                        const ConeOfInfluence& relevance, const SafetyProperty& watch,
                        unsigned effort) {
  ChcEncoder writer(context, proof_context, relevance, watch);
  if (!writer.run()) {
    return {Answer::Unknown, std::nullopt, "the mission has too many call stacks",
            Budget::kRule * writer.rules().size()};
  }
  Engine engine(context, writer.rules());
  const z3::check_result result = engine.ask();
  RunsAnswer answer;
  answer.steps = engine.steps() + Budget::kRule * writer.rules().size();
  if (result == z3::unknown) {
    answer.trouble = engine.reason();
    return answer;
  }
  if (result == z3::unsat) {
    answer.bad = Answer::No;
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
