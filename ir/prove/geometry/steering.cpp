// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/geometry/steering.h"

#include "ir/prove/abstract/abstract_run.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/context/same_expression.h"

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {
namespace {

/// Adds the corners of the box in which a computed place lies; false if it may be anywhere.
bool addBox(const Interval& north, const Interval& east, std::vector<Position>& places) {
  if (north.empty || east.empty || north.lowest <= -90 || north.highest >= 90 ||
      east.highest - east.lowest >= 180) {
    return false;
  }
  for (const double latitude : {north.lowest, north.highest}) {
    for (const double longitude : {east.lowest, east.highest}) {
      places.push_back({latitude, longitude});
    }
  }
  return true;
}

/// Whether a path gives the command both coordinates from one row, so that the target is one of its
/// places.
bool fromOneRow(const Mission& m, const Expr& north, const Expr& east) {
  return isSameExpression(m, north.operands[0], east.operands[0]) &&
         m[north.table].values.size() == m[east.table].values.size();
}

/// False if the target may be anywhere.
bool addTarget(const ProofContext& proof_context, const Statement& statement,
               std::vector<Position>& places) {
  const ExprId north = statement.values.at(0);
  const ExprId east = statement.values.at(1);
  const std::vector<Position> path = pathTargets(proof_context.mission, statement);
  if (path.empty()) {
    return addBox(proof_context.intervals[north.index], proof_context.intervals[east.index],
                  places);
  }
  places.insert(places.end(), path.begin(), path.end());
  return fromOneRow(proof_context.mission, proof_context.mission[north],
                    proof_context.mission[east]);
}

/// What the start of the mission commands about the heading, for any readings of the sensors.
class FirstHeading {
 public:
  explicit FirstHeading(const ProofContext& proof_context)
      : m_(proof_context.mission),
        values_(atStart(proof_context)),
        now_(proof_context, values_, kStart),
        proof_context_(proof_context) {}

  /// Whether every path through the entries of the first state commands one.
  [[nodiscard]] bool commanded() const {
    const State& first = m_.states.front();
    return commands(first.entry) || commands(first.profile.entry) || commands(first.route.entry);
  }

 private:
  static constexpr ClockRanges kStart{};

  /// The values that variables may have at any moment of the entries.
  static Valuation atStart(const ProofContext& proof_context) {
    const AbstractRun run(proof_context);
    const State& first = proof_context.mission.states.front();
    Valuation values = run.begin();
    run.enter(StateId{0}, nullptr, kStart, values);
    for (const BlockId entry : {first.entry, first.profile.entry, first.route.entry}) {
      run.forget(entry, values);
    }
    return values;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] bool commands(BlockId block) const {
    return block.valid() &&
           std::ranges::any_of(m_[block].statements, [&](const Statement& statement) {
             return statement.kind == StatementKind::Command ? takesEffect(statement)
                                                             : bothWays(statement);
           });
  }

  /// An unknown condition takes neither branch.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] bool bothWays(const Statement& statement) const {
    if (statement.kind != StatementKind::If) {
      return false;
    }
    const Truths& condition = now_.truth(statement.value);
    return !condition.is_unknown && (!condition.is_true || commands(statement.then)) &&
           (!condition.is_false || commands(statement.otherwise));
  }

  /// A command with an unknown argument changes nothing.
  [[nodiscard]] bool takesEffect(const Statement& command) const {
    return !isVertical(command.command) &&
           std::ranges::all_of(command.values, [&](ExprId id) { return isKnown(id); });
  }

  [[nodiscard]] bool isKnown(ExprId id) const {
    const Expr& e = m_[id];
    if (e.op != Op::Element) {
      return !now_.maybeUnknown(id);
    }
    const ExprId row = e.operands[0];
    const Interval& rows = now_.number(row);
    const auto last = static_cast<double>(m_[e.table].values.size() - 1);
    const bool one = rows.lowest == rows.highest && std::floor(rows.lowest) == rows.lowest;
    return !now_.maybeUnknown(row) && (one || proof_context_.whole[row.index]) && !rows.empty &&
           rows.lowest >= 0 && rows.highest <= last;
  }

  const Mission& m_;
  Valuation values_;
  AbstractEvaluator now_;
  const ProofContext& proof_context_;
};

/// Adds the targets of some commands.
void addCommands(const ProofContext& proof_context, const std::vector<const Statement*>& commands,
                 Steering& steering) {
  for (const Statement* command : commands) {
    const bool somewhere = command->command == Command::SteerTo &&
                           addTarget(proof_context, *command, steering.waypoints);
    steering.by_heading = steering.by_heading || !(somewhere || isVertical(command->command));
  }
}

}  // namespace

Steering steeringOf(const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  Steering steering;
  const auto noteWhere = [&](const std::string& where) {
    if (steering.by_heading && steering.where.empty()) {
      steering.where = where;
    }
  };
  addCommands(proof_context, commandsOfAlways(m), steering);
  noteWhere("in `always`");
  for (const State& state : m.states) {
    const bool in_c =
        !m[state.profile.behaviour].symbol.empty() || !m[state.route.behaviour].symbol.empty();
    steering.by_heading = steering.by_heading || in_c;
    addCommands(proof_context, commandsOf(m, state), steering);
    noteWhere("in `" + state.name + "`");
  }
  steering.by_heading = steering.by_heading || !FirstHeading(proof_context).commanded();
  noteWhere("at the start");
  return steering;
}

}  // namespace glider::ir::prove
