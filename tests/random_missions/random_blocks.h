// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/random_missions/random_expressions.h"

namespace glider::random_missions {

/// Adds random blocks, of statements that stand where the expressions do.
class BlockMaker {
 public:
  BlockMaker(ir::Mission& mission, Random& random, ExpressionMaker& expressions)
      : m_(mission), random_(random), expressions_(expressions) {}

  /// A block in which `if` nests at most `depth` deep.
  ir::BlockId block(uint32_t depth);

 private:
  ir::Statement statement(uint32_t depth);
  ir::Statement set();
  ir::Statement condition(uint32_t depth);
  ir::Statement log();
  ir::Statement command();

  ir::Mission& m_;
  Random& random_;
  ExpressionMaker& expressions_;
};

}  // namespace glider::random_missions
