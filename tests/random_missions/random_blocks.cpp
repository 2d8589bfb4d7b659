// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_missions/random_blocks.h"

#include "ir/core/ops.h"

#include <fmt/format.h>

namespace glider::random_missions {

using ir::StatementKind;

ir::BlockId BlockMaker::block(uint32_t depth) {
  // Now and then more notes than a tick keeps.
  const uint32_t count = random_.chance(0.03) ? 20 : random_.below(4);
  ir::Block block;
  for (uint32_t i = 0; i < count; ++i) {
    block.statements.push_back(count == 20 ? log() : statement(depth));
  }
  m_.blocks.push_back(std::move(block));
  return {static_cast<uint32_t>(m_.blocks.size() - 1)};
}

ir::Statement BlockMaker::statement(uint32_t depth) {
  switch (random_.below(depth == 0 ? 5 : 6)) {
    case 0:
    case 1:
      return set();
    case 2:
      return log();
    case 3:
    case 4:
      return command();
    default:
      return condition(depth - 1);
  }
}

ir::Statement BlockMaker::set() {
  std::vector<uint32_t> settable;
  for (uint32_t i = expressions_.scope().sets_from; i < m_.variables.size(); ++i) {
    const ir::Variable& v = m_.variables[i];
    if (v.kind != ir::VariableKind::Parameter && v.kind != ir::VariableKind::Argument &&
        (!v.owner.valid() || v.owner == expressions_.scope().state)) {
      settable.push_back(i);
    }
  }
  if (settable.empty()) {
    return log();
  }
  ir::Statement s;
  s.variable = {random_.pick(settable)};
  s.value = expressions_.valueFor(m_[s.variable], random_.between(0, 2));
  return s;
}

ir::Statement BlockMaker::condition(uint32_t depth) {
  ir::Statement s;
  s.kind = StatementKind::If;
  s.value = expressions_.guard(random_.between(0, 2));
  s.then = block(depth);
  if (random_.chance(0.5)) {
    s.otherwise = block(depth);
  }
  return s;
}

ir::Statement BlockMaker::log() {
  ir::Statement s;
  s.kind = StatementKind::Log;
  s.text = fmt::format("note {}", random_.below(100));
  for (uint32_t k = random_.below(8); k > 0; --k) {
    s.values.push_back(random_.chance(0.2) ? expressions_.guard(1)
                                           : expressions_.number(random_.pick(m_.sensors).type, 1));
  }
  return s;
}

ir::Statement BlockMaker::command() {
  ir::Statement s;
  s.kind = StatementKind::Command;
  const ir::CommandInfo& info = random_.pick(ir::commands());
  s.command = info.command;
  for (const ir::Parameter& p : info.parameters) {
    s.values.push_back(expressions_.number(p.type, random_.between(0, 2)));
  }
  return s;
}

}  // namespace glider::random_missions
