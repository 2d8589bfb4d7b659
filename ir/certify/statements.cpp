// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Statements and initial values: README S and E2.

#include "ir/certify/tick.h"
#include "support/check.h"

#include <algorithm>

namespace glider::ir::certify {

/// E2, E8, S5: an initial value that is unknown makes the variable unknown.
void Tick::initialise(VariableId id, Path& path) {
  const ExprId initial = setting_.mission[id].initial;
  assign(id, initial, expressions_.evaluate(initial, path.store), path);
}

/// The variable gets the value, even if that is unknown. That a known one is in the variable's
/// range must be shown, unless its interval shows it.
void Tick::assign(VariableId id, ExprId expr, const Value& value, Path& path) {
  const Range& declared = setting_.facts.declared[id.index];
  const Range& range = setting_.facts.ranges[expr.index];
  const bool inside = declared.lowest <= range.lowest && range.highest <= declared.highest;
  if (const auto* n = std::get_if<Number>(&value); n != nullptr && !inside) {
    const Term within =
        operation("<=", {literal(declared.lowest), n->value, literal(declared.highest)});
    out_of_range_.push_back(out_.boolean(conjunction({path.taken, n->known, negation(within)})));
  }
  path.store.variables.at(id.index) = value;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void Tick::run(BlockId block, Path& path) {
  if (block.valid()) {
    for (const Statement& s : setting_.mission[block].statements) {
      execute(s, path);
    }
  }
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void Tick::execute(const Statement& s, Path& path) {
  switch (s.kind) {
    case StatementKind::Set: {  // S1: an unknown value changes nothing
      const Value value = expressions_.evaluate(s.value, path.store);
      const auto* n = std::get_if<Number>(&value);
      const auto* t = std::get_if<Truths>(&value);
      const Term known =
          n != nullptr ? n->known : out_.boolean(disjunction({t->is_true, t->is_false}));
      const Value before = path.store.variables.at(s.variable.index);
      assign(s.variable, s.value, value, path);
      Value& after = path.store.variables.at(s.variable.index);
      after = merged(out_, known, after, before);
      return;
    }
    case StatementKind::If: {  // S2: an unknown condition runs neither branch
      const Truths condition = expressions_.truth(s.value, path.store);
      Path then{out_.boolean(conjunction({path.taken, condition.is_true})), path.store};
      Path otherwise{out_.boolean(conjunction({path.taken, condition.is_false})), path.store};
      run(s.then, then);
      run(s.otherwise, otherwise);
      path.store = merged(out_, condition.is_false, otherwise.store, path.store);
      path.store = merged(out_, condition.is_true, then.store, path.store);
      return;
    }
    case StatementKind::Log:  // S3
      return;
    case StatementKind::Command: {  // S4
      std::vector<Number> arguments;
      for (const ExprId argument : s.values) {
        arguments.push_back(expressions_.number(argument, path.store));
      }
      path.store.vehicle =
          commanded(setting_, out_, path.store.vehicle, s.command, arguments, expressions_.time());
      return;
    }
  }
  CHECK(false, "a statement without a meaning");
}

bool Tick::sees(const Observation& observation, const Outcome& outcome) const {
  const Configuration& after = outcome.to ? *outcome.to : at_;  // a mission that ends stays put
  switch (observation.kind) {
    case ObservationKind::Entered:
      return outcome.entered.valid() && outcome.entered == observation.state;
    case ObservationKind::Inside:
      return after.state == observation.state ||
             std::ranges::find(after.stack, observation.state, &Waiting::state) !=
                 after.stack.end();
    case ObservationKind::Ended:
      break;
  }
  return !outcome.to;
}

/// What a momentary variable was in the tick before is forgotten. The statements read the true
/// depth, and what they set has no range.
void Tick::observe(Outcome& outcome) {
  const ir::Monitor& monitor = setting_.requirement.monitor;
  if (!monitor.step.valid()) {
    return;
  }
  for (uint32_t i = 0; i < setting_.mission.variables.size(); ++i) {
    if (setting_.mission.variables[i].kind == VariableKind::Momentary) {
      outcome.store.variables[i] = Truths();
    }
  }
  for (const Observation& observation : monitor.observations) {
    const bool seen = sees(observation, outcome);
    outcome.store.variables.at(observation.variable.index) =
        Truths{seen ? "true" : "false", seen ? "false" : "true"};
  }
  Path path{outcome.condition, std::move(outcome.store)};
  expressions_.readTrueDepth(true);
  run(monitor.step, path);
  expressions_.readTrueDepth(false);
  outcome.store = std::move(path.store);
}

}  // namespace glider::ir::certify
