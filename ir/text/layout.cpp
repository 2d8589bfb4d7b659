// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/layout.h"

#include "ir/core/ops.h"

#include <algorithm>

namespace glider::ir::text {
namespace {

/// Deeper trees are cut by a name: well below what the reader takes.
constexpr uint32_t kDeepest = 32;

std::vector<uint32_t> countUses(const Mission& mission) {
  std::vector<uint32_t> uses(mission.exprs.size());
  auto count = [&](ExprId id) { ++uses[id.index]; };
  for (const Expr& e : mission.exprs) {
    std::for_each_n(e.operands.begin(), opInfo(e.op).operands, count);
  }
  for (const State& s : mission.states) {
    std::ranges::for_each(s.route.arguments, count);
    std::ranges::for_each(s.profile.arguments, count);
    std::ranges::for_each(s.log, count, &LogItem::value);
    std::ranges::for_each(s.cases, count, &Case::guard);
  }
  return uses;
}

}  // namespace

Layout layOut(const Mission& mission) {
  const size_t count = mission.exprs.size();
  Layout layout{countUses(mission), std::vector<uint32_t>(count), std::vector<bool>(count)};
  std::vector<uint32_t> depth(count, 1);
  for (uint32_t i = 0; i < count; ++i) {
    const Expr& e = mission.exprs[i];
    uint32_t first = i;
    for (uint32_t k = opInfo(e.op).operands; k-- > 0;) {
      const uint32_t operand = e.operands.at(k).index;
      if (operand + 1 == first && layout.uses[operand] == 1 && depth[operand] < kDeepest) {
        layout.inside[operand] = true;
        first = layout.first[operand];
        depth[i] = std::max(depth[i], depth[operand] + 1);
      }
    }
    layout.first[i] = first;
  }
  return layout;
}

}  // namespace glider::ir::text
