// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/ops.h"

#include <algorithm>
#include <array>
#include <unordered_set>
#include <vector>

namespace glider::ir {
namespace detail {

/// Numbers of expressions that a walk has met. Almost every expression has few parts, and missions
/// have tens of thousands: those few are looked through, without a hash and its memory.
class MetExprs {
 public:
  /// False if it was met before.
  bool add(uint32_t index) {
    const auto end = few_.begin() + count_;
    if (std::find(few_.begin(), end, index) != end) {
      return false;
    }
    if (static_cast<size_t>(count_) == few_.size()) {
      return many_.insert(index).second;
    }
    few_[static_cast<size_t>(count_++)] = index;
    return true;
  }

 private:
  std::array<uint32_t, 16> few_;
  std::ptrdiff_t count_ = 0;
  std::unordered_set<uint32_t> many_;  ///< those for which `few_` has no room
};

}  // namespace detail

/// Whether `is` holds for the expression at `root` or for one in it; each is checked once, even if
/// it occurs several times. `is` takes an Expr.
template <typename Predicate>
bool anyIn(const Mission& mission, ExprId root, Predicate is) {
  constexpr size_t kUsual = 8;  // more than this are rarely open at once
  std::vector<ExprId> open;
  open.reserve(kUsual);
  open.push_back(root);
  detail::MetExprs met;
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!met.add(id.index)) {
      continue;
    }
    const Expr& e = mission[id];
    if (is(e)) {
      return true;
    }
    open.insert(open.end(), e.operands.begin(), e.operands.begin() + operandCount(e));
  }
  return false;
}

/// Calls `visit` once for the expression at `root` and for each one in it.
template <typename Visit>
void forEachIn(const Mission& mission, ExprId root, Visit visit) {
  (void)anyIn(mission, root, [&](const Expr& e) {
    visit(e);
    return false;
  });
}

/// Calls `visit` for each statement of a block in the order of the text; an `if` comes before both
/// its branches. An invalid id is an empty block.
template <typename Visit>
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void forEachStatement(const Mission& mission, BlockId block, const Visit& visit) {
  if (!block.valid()) {
    return;
  }
  for (const Statement& statement : mission[block].statements) {
    visit(statement);
    if (statement.kind == StatementKind::If) {
      forEachStatement(mission, statement.then, visit);
      forEachStatement(mission, statement.otherwise, visit);
    }
  }
}

}  // namespace glider::ir
