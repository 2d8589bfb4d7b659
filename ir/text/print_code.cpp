// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The Printer's cases, blocks and expressions.

#include "ir/core/ops.h"
#include "ir/text/print.h"
#include "ir/text/printer.h"

#include <algorithm>
#include <array>

namespace glider::ir::text {

void Printer::temporal(const Temporal& t) {
  constexpr std::string_view kKinds[] = {"became",     "held",     "mean",        "lowest",
                                         "highest",    "spread",   "slope",       "at_lowest",
                                         "at_highest", "steepest", "at_steepest", "number"};
  constexpr std::string_view kLists[] = {"always", "state", "profile", "route"};
  std::vector<ExprId> ids = {t.operand};
  for (ExprId id : {t.duration, t.along}) {
    if (id.valid()) {
      ids.push_back(id);
    }
  }
  prepare(ids);
  line("temporal {} {} ", kKinds[static_cast<size_t>(t.kind)], kLists[static_cast<size_t>(t.list)]);
  if (t.state.valid()) {
    add("{} ", nameText(m_[t.state].name));
  }
  use(t.operand);
  if (t.kind == TemporalKind::Held) {
    add(" for ");
    use(t.duration);
  }
  if (isWindow(t.kind) && t.duration.valid()) {
    add(" where ");
    use(t.duration);
  }
  if (t.leg != Leg::None) {
    add(" over {} {} {}", t.leg == Leg::This ? "this" : "last", t.dive, t.climb);
  } else if (isWindow(t.kind)) {
    add(" over {}", t.length);
  }
  if (t.along.valid()) {
    add(" along ");
    use(t.along);
  }
}

void Printer::cases(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    defineBlocks(c.action);
    prepare({&c.guard, 1});
    line("case {}", c.implied ? "implied " : "");
    use(c.guard);
    if (c.action.valid()) {
      add(" ");
      useBlock(c.action, "do");
    }
    if (!c.arguments.empty()) {
      ++indent_;
      prepare(c.arguments);
      --indent_;
    }
    add(" {}", wordOf(c.transition));
    if (c.target.valid()) {
      add(" {}", nameText(m_[c.target].name));
    }
    if (!c.arguments.empty()) {
      add(" ");
      list(c.arguments);
    }
  }
}

void Printer::entry(BlockId block) {
  if (block.valid()) {
    defineBlocks(block);
    line("entry ");
    useBlock(block, "do");
  }
}

/// Writes the blocks before `user`, and `user` itself if it cannot be written in its place.
void Printer::defineBlocks(BlockId user) {
  if (!user.valid() || block_first_[user.index] == next_block_) {
    return;
  }
  while (next_block_ <= user.index) {
    line("block ");
    useBlock({next_block_}, "do");
  }
}

/// `word`, statements and `end`; or the number of a block that has been written.
void Printer::useBlock(BlockId block, std::string_view word) {
  if (block.index < next_block_) {
    add("run {}", block.index);
    return;
  }
  add("{}", word);
  statements(block);
  line("end");
}

/// Recursion is as deep as the layout lets blocks nest.
void Printer::statements(BlockId block) {
  ++indent_;
  std::ranges::for_each(m_[block].statements, [&](const Statement& s) { statement(s); });
  --indent_;
  next_block_ = block.index + 1;
}

void Printer::statement(const Statement& s) {
  switch (s.kind) {
    case StatementKind::Set:
      prepare({&s.value, 1});
      line("set {} ", nameText(m_[s.variable].name));
      use(s.value);
      return;
    case StatementKind::If:
      condition(s);
      return;
    case StatementKind::Log:
      prepare(s.values);
      line("log {} ", nameText(s.text));
      list(s.values);
      return;
    case StatementKind::Command:
      prepare(s.values);
      line("{} ", commands()[static_cast<size_t>(s.command)].text);
      list(s.values);
      return;
  }
}

void Printer::condition(const Statement& s) {
  prepare({&s.value, 1});
  line("if ");
  use(s.value);
  for (BlockId block : {s.then, s.otherwise}) {
    if (!block.valid()) {
      continue;
    }
    if (block == s.otherwise) {
      line("else");
    }
    if (block.index < next_block_) {
      add(" run {}", block.index);
    } else {
      statements(block);
    }
  }
  line("end");
}

/// Defines by `let` what must have a name before the expressions `ids` can be written in a row.
void Printer::prepare(std::span<const ExprId> ids) {
  auto pending = [&](ExprId id) { return id.index >= next_; };
  auto start = std::ranges::find_if(ids, pending);
  if (start == ids.end()) {
    return;
  }
  const uint32_t first = layout_.first[start->index];
  uint32_t number = first;
  for (ExprId id : ids) {
    if (layout_.uses[id.index] == 1 && layout_.first[id.index] == number) {
      number = id.index + 1;
    } else if (id.index >= number) {
      defineUpTo(std::ranges::max(ids).index + 1);
      return;
    }
  }
  defineUpTo(first);
}

/// Names every expression below number `end` that has not been written yet.
void Printer::defineUpTo(uint32_t end) {
  while (defineNext(end)) {
  }
  while (next_ < end) {
    uint32_t root = next_;
    while (layout_.inside[root]) {
      ++root;
    }
    line("let %{} = ", root);
    use({root});
  }
}

/// Writes a temporal, an initial value or a condition whose expressions are all below number `end`;
/// false if there is none, or one is being written: they are written one after the other.
bool Printer::defineNext(uint32_t end) {
  if (defining_) {
    return false;
  }
  defining_ = true;
  const bool written = writeNext(end);
  defining_ = false;
  return written;
}

bool Printer::writeNext(uint32_t end) {
  auto below = [&](ExprId id) { return !id.valid() || id.index < end; };
  if (next_temporal_ < m_.temporals.size()) {
    const Temporal& t = m_.temporals[next_temporal_];
    if (below(t.operand) && below(t.duration) && below(t.along)) {
      ++next_temporal_;
      temporal(t);
      return true;
    }
  }
  if (next_initial_ < m_.variables.size() && below(m_.variables[next_initial_].initial)) {
    const Variable& v = m_.variables[next_initial_++];
    if (v.initial.valid()) {
      prepare({&v.initial, 1});
      line("initial {} ", nameText(v.name));
      use(v.initial);
    }
    return true;
  }
  if (next_condition_ < m_.conditions.size() && below(m_.conditions[next_condition_])) {
    const ExprId& id = m_.conditions[next_condition_++];
    prepare({&id, 1});
    line("condition ");
    use(id);
    return true;
  }
  return false;
}

void Printer::use(ExprId id) {
  if (id.index < next_) {
    add("%{}", id.index);
  } else {
    tree(id.index);
    next_ = id.index + 1;
  }
}

void Printer::list(std::span<const ExprId> ids) {
  add("(");
  for (size_t i = 0; i < ids.size(); ++i) {
    add("{}", i == 0 ? "" : ", ");
    use(ids[i]);
  }
  add(")");
}

/// Recursion is as deep as the layout lets trees nest.
void Printer::tree(uint32_t i) {
  const Expr& e = m_.exprs[i];
  const OpInfo& op = opInfo(e.op);
  const uint32_t count = operandCount(e);
  if (count == 0) {
    leaf(e);
    return;
  }
  add("({}", op.text);
  if (e.table.valid()) {
    add(" {}", e.table.index);
  } else if (e.use.valid()) {
    add(" {}", e.use.index);
  }
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t operand = e.operands.at(k).index;
    add(" ");
    if (layout_.inside[operand]) {
      tree(operand);
    } else {
      add("%{}", operand);
    }
  }
  add(")");
}

void Printer::leaf(const Expr& e) {
  const std::string_view op = opInfo(e.op).text;
  if (e.op == Op::Constant) {
    constexpr Type kPlain;
    add("{}{}", e.number, e.type == kPlain ? "" : ":" + typeText(e.type));
  } else if (e.sensor.valid()) {
    add("({} {})", op, nameText(m_[e.sensor].name));
  } else if (e.variable.valid()) {
    add("({} {})", op, nameText(m_[e.variable].name));
  } else if (e.temporal.valid()) {
    add("({} {})", op, e.temporal.index);
  } else if (e.use.valid()) {
    add("({} {})", op, e.use.index);
  } else {
    add("{}", op);
  }
}

}  // namespace glider::ir::text
