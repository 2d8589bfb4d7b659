// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/text/expression_reader.h"
#include "ir/text/names.h"

#include <functional>
#include <utility>
#include <vector>

namespace glider::ir::text {

/// Reads the code of a mission: definitions, blocks and cases. States may be named before they are
/// defined; `findTargets` at the end resolves the names.
class CodeReader {
 public:
  CodeReader(Cursor& in, Mission& mission, Names& sensors, Names& variables)
      : in_(in),
        m_(mission),
        variables_(variables),
        expressions_(in, mission, sensors, variables) {}

  /// `(`, any number of what `element` reads with commas between, `)`.
  template <typename Element>
  void list(Element element) {
    in_.expect('(');
    if (in_.accept(')')) {
      return;
    }
    do {
      element();
    } while (in_.accept(','));
    in_.expect(')');
  }

  ExprId expression() { return expressions_.expression(); }
  std::vector<ExprId> expressionList();
  /// A `let`, `temporal`, `initial`, `condition` or `block`, if the next token begins one.
  bool definition();
  /// What follows the word `entry`, if `block` is not there yet.
  void entry(BlockId& block);
  /// What follows the word `case` at `begin`. `list` returns the list to add it to.
  void caseInto(std::function<std::vector<Case>&()> list, support::SourceRange begin);
  /// The name of a state; `place` is called with it once all states are read.
  void stateName(std::function<void(StateId)> place);
  VariableId variableName();
  void findTargets(Names& states);

 private:
  void temporal(support::SourceRange begin);
  void initial();
  BlockId block(uint32_t depth);
  BlockId statements(uint32_t depth);
  bool statement(Statement& s, uint32_t depth);
  void condition(Statement& s, uint32_t depth);
  BlockId branch(uint32_t depth);
  BlockId runBlock();
  bool command(Statement& s);
  Transition transition();

  Cursor& in_;
  Mission& m_;
  Names& variables_;
  ExpressionReader expressions_;
  std::vector<std::pair<Token, std::function<void(StateId)>>> targets_;
};

}  // namespace glider::ir::text
