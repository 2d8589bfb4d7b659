// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the interpreter does inside a `do`: statements, notes, calls of C functions.

#include "ir/core/pilot_name.h"
#include "ir/eval/arithmetic.h"
#include "ir/eval/interpreter.h"
#include "support/check.h"

#include <algorithm>
#include <utility>

namespace glider::ir {
namespace {

constexpr size_t kMostNotes = 16;
constexpr size_t kMostNoteValues = 64;

}  // namespace

std::vector<double> Interpreter::numbers(std::span<const ExprId> ids) const {
  std::vector<double> values;
  for (ExprId id : ids) {
    values.push_back(asNumber(evaluate(id)));
  }
  return values;
}

/// A C function.
void Interpreter::call(ListKind list, Phase phase) {
  const Activity& a = activity(list);
  told_.actions.emplace_back(ActivityRun{list, a.behaviour, phase, numbers(a.arguments)});
}

void Interpreter::run(BlockId block) {
  if (block.valid()) {
    for (const Statement& statement : mission_[block].statements) {
      execute(statement);
    }
  }
}

void Interpreter::execute(const Statement& s) {
  switch (s.kind) {
    case StatementKind::Set: {
      const double value = asNumber(evaluate(s.value));
      if (isKnown(value)) {
        assign(s.variable, value);
      } else {
        note(NoteKind::UnknownSet, pilotName(mission_, s.variable), {});
      }
      return;
    }
    case StatementKind::If: {
      const Truth condition = truthOf(s.value);
      if (condition != Truth::Unknown) {
        run(condition == Truth::True ? s.then : s.otherwise);
      }
      return;
    }
    case StatementKind::Log:
      note(NoteKind::Log, s.text, numbers(s.values));
      return;
    case StatementKind::Command: {
      CommandRun run{s.command, numbers(s.values), false};
      run.refused = !std::ranges::all_of(run.arguments, isKnown);
      told_.actions.emplace_back(std::move(run));
      return;
    }
  }
}

void Interpreter::assign(VariableId id, double value) {
  const Variable& v = mission_[id];
  CHECK(!isKnown(value) || (value >= v.lowest && value <= v.highest),
        "a variable outside its range");
  variables_.at(id.index) = value;
}

void Interpreter::note(NoteKind kind, const std::string& text, std::vector<double> values) {
  if (told_.notes.size() == kMostNotes) {
    ++told_.lost_notes;
    return;
  }
  size_t room = kMostNoteValues;
  for (const Note& note : told_.notes) {
    room -= note.values.size();
  }
  if (values.size() > room) {
    ++told_.lost_notes;
    values.resize(room);
  }
  told_.notes.push_back({kind, text, std::move(values)});
}

}  // namespace glider::ir
