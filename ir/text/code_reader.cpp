// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/code_reader.h"

#include "ir/core/mission_writer.h"
#include "ir/core/ops.h"
#include "support/diagnostics/ids/ir_text.h"

#include <algorithm>
#include <array>

namespace glider::ir::text {
namespace {

using support::SourceRange;

constexpr uint32_t kDeepestBlock = 200;

/// Accepts the next token if it is in `words` and returns its index; the number of `words` if it is
/// not.
template <size_t N>
size_t choose(Cursor& in, const std::array<std::string_view, N>& words) {
  return static_cast<size_t>(
      std::ranges::find_if(words, [&](std::string_view word) { return in.accept(word); }) -
      words.begin());
}

}  // namespace

std::vector<ExprId> CodeReader::expressionList() {
  std::vector<ExprId> ids;
  list([&] { ids.push_back(expression()); });
  return ids;
}

VariableId CodeReader::variableName() {
  return {variables_.find(in_.nameToken("the name of a variable"))};
}

void CodeReader::stateName(std::function<void(StateId)> place) {
  targets_.emplace_back(in_.nameToken("the name of a state"), std::move(place));
}

void CodeReader::findTargets(Names& states) {
  for (const auto& [name, place] : targets_) {
    if (!in_.failed()) {
      place({states.find(name)});
    }
  }
}

bool CodeReader::definition() {
  const SourceRange begin = in_.peek().range;
  if (in_.accept("let")) {
    expressions_.let();
  } else if (in_.accept("temporal")) {
    temporal(begin);
  } else if (in_.accept("initial")) {
    initial();
  } else if (in_.accept("condition")) {
    m_.conditions.push_back(expression());
  } else if (in_.accept("block")) {
    block(0);
  } else {
    return false;
  }
  return true;
}

void CodeReader::temporal(SourceRange begin) {
  constexpr auto kKinds = std::to_array<std::string_view>(
      {"became", "held", "mean", "lowest", "highest", "spread", "slope", "at_lowest", "at_highest",
       "steepest", "at_steepest", "number"});
  constexpr auto kLists = std::to_array<std::string_view>({"always", "state", "profile", "route"});
  Temporal t;
  const size_t kind = choose(in_, kKinds);
  if (kind == kKinds.size()) {
    in_.failExpecting("`became`, `held` or the name of a window");
    return;
  }
  t.kind = static_cast<TemporalKind>(kind);
  const size_t which = choose(in_, kLists);
  if (which == kLists.size()) {
    in_.failExpecting("`always`, `state`, `profile` or `route`");
    return;
  }
  t.list = static_cast<ListKind>(which);
  const size_t number = m_.temporals.size();
  if (t.list != ListKind::Always) {
    stateName([this, number](StateId id) { m_.temporals[number].state = id; });
  }
  t.operand = expression();
  if (t.kind == TemporalKind::Held) {
    in_.expect("for");
    t.duration = expression();
  } else if (isWindow(t.kind)) {
    if (in_.accept("where")) {
      t.duration = expression();
    }
    in_.expect("over");
    t.leg = in_.accept("this") ? Leg::This : in_.accept("last") ? Leg::Last : Leg::None;
    if (t.leg == Leg::None) {
      t.length = in_.number(false);
    } else {
      t.dive = in_.number(false);
      t.climb = in_.number(false);
    }
    t.along = in_.accept("along") ? expression() : ExprId();
  }
  t.range = in_.since(begin);
  m_.temporals.push_back(t);
}

void CodeReader::initial() {
  const Token name = in_.peek();
  const VariableId id = variableName();
  const ExprId value = expression();
  if (in_.failed()) {
    return;
  }
  if (m_[id].initial.valid()) {
    in_.fail(support::diagnostics::irDefinedTwice, name.range, "initial value of", name.text);
    return;
  }
  m_.variables[id.index].initial = value;
}

void CodeReader::entry(BlockId& place) {
  if (place.valid()) {
    in_.fail(support::diagnostics::irDefinedTwice, in_.peek().range, "action", "entry");
    return;
  }
  place = block(0);
}

/// `do`, statements, `end`; or `run` and a number.
BlockId CodeReader::block(uint32_t depth) {
  if (in_.peek().isWord("run")) {
    return runBlock();
  }
  in_.expect("do");
  const BlockId id = statements(depth);
  in_.expect("end");
  return id;
}

/// `run` and the number of a block above.
BlockId CodeReader::runBlock() {
  in_.expect("run");
  const Token number = in_.peek();
  const BlockId id{static_cast<uint32_t>(in_.integer(0, UINT32_MAX))};
  if (id.index >= m_.blocks.size()) {
    in_.fail(support::diagnostics::irUnknownName, number.range, "block", number.text);
    return {};
  }
  return id;
}

/// Reads statements up to a word that does not begin one.
BlockId CodeReader::statements(uint32_t depth) {
  if (depth > kDeepestBlock) {
    in_.fail(support::diagnostics::irBlocksTooDeep, in_.peek().range, kDeepestBlock);
    return {};
  }
  Block block;
  while (!in_.failed()) {
    if (definition()) {
      continue;
    }
    Statement s;
    const SourceRange begin = in_.peek().range;
    if (!statement(s, depth)) {
      break;
    }
    s.range = in_.since(begin);
    block.statements.push_back(std::move(s));
  }
  return MissionWriter(m_).add(std::move(block));
}

bool CodeReader::statement(Statement& s, uint32_t depth) {
  if (in_.accept("set")) {
    s.variable = variableName();
    s.value = expression();
  } else if (in_.accept("if")) {
    condition(s, depth);
  } else if (in_.accept("log")) {
    s.kind = StatementKind::Log;
    s.text = in_.name("a string");
    s.values = expressionList();
  } else {
    return command(s);
  }
  return true;
}

void CodeReader::condition(Statement& s, uint32_t depth) {
  s.kind = StatementKind::If;
  s.value = expression();
  s.then = branch(depth);
  if (in_.accept("else")) {
    s.otherwise = branch(depth);
  }
  in_.expect("end");
}

BlockId CodeReader::branch(uint32_t depth) {
  return in_.peek().isWord("run") ? runBlock() : statements(depth + 1);
}

bool CodeReader::command(Statement& s) {
  for (const CommandInfo& info : commands()) {
    if (in_.accept(info.text)) {
      s.kind = StatementKind::Command;
      s.command = info.command;
      s.values = expressionList();
      return true;
    }
  }
  return false;
}

Transition CodeReader::transition() {
  const size_t which = choose(in_, kTransitionWords);
  if (which == kTransitionWords.size()) {
    in_.failExpecting("`goto`, `call`, `return`, `exit`, `stay` or `done`");
    return Transition::Stay;
  }
  return static_cast<Transition>(which);
}

void CodeReader::caseInto(std::function<std::vector<Case>&()> list, SourceRange begin) {
  Case c;
  c.implied = in_.accept("implied");
  c.guard = expression();
  if (in_.peek().isWord("do") || in_.peek().isWord("run")) {
    c.action = block(0);
  }
  while (!in_.failed() && definition()) {
  }
  c.transition = transition();
  if (c.transition == Transition::Goto || c.transition == Transition::Call) {
    const size_t number = list().size();
    stateName([list, number](StateId id) { list()[number].target = id; });
    if (in_.peek().isMark('(')) {
      c.arguments = expressionList();
    }
  }
  c.range = in_.since(begin);
  list().push_back(std::move(c));
}

}  // namespace glider::ir::text
