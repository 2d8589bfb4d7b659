// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/text/names.h"

namespace glider::ir::text {

/// Reads expressions into a mission; each is numbered when it ends.
class ExpressionReader {
 public:
  ExpressionReader(Cursor& in, Mission& mission, Names& sensors, Names& variables)
      : in_(in), m_(mission), sensors_(sensors), variables_(variables), lets_(in, "expression") {}

  /// What follows the word `let`: `%name = expression`.
  void let();
  /// An expression; invalid after an error.
  ExprId expression() { return nested(0); }

 private:
  ExprId nested(uint32_t depth);
  ExprId constant(support::SourceRange begin);
  void leaf(Expr& e);
  uint32_t number(std::string_view what, size_t count);
  ExprId operation(support::SourceRange begin, uint32_t depth);
  ExprId add(Expr e, support::SourceRange begin);

  Cursor& in_;
  Mission& m_;
  Names& sensors_;
  Names& variables_;
  Names lets_;
};

}  // namespace glider::ir::text
