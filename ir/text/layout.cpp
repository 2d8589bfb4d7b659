// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/layout.h"

#include "ir/core/ops.h"

#include <algorithm>

namespace glider::ir::text {
namespace {

/// Deeper trees are divided by a name: well below the reader's limit.
constexpr uint32_t kDeepest = 32;

std::vector<uint32_t> countUses(const Mission& mission) {
  std::vector<uint32_t> uses(mission.exprs.size());
  auto count = [&](ExprId id) {
    if (id.valid()) {
      ++uses[id.index];
    }
  };
  auto countCases = [&](const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      count(c.guard);
      std::ranges::for_each(c.arguments, count);
    }
  };
  for (const Expr& e : mission.exprs) {
    std::for_each_n(e.operands.begin(), operandCount(e), count);
  }
  std::ranges::for_each(mission.variables, count, &Variable::initial);
  for (const Temporal& t : mission.temporals) {
    count(t.operand);
    count(t.duration);
    count(t.along);
  }
  std::ranges::for_each(mission.conditions, count);
  for (const Requirement& r : mission.requirements) {
    count(r.condition);
    std::ranges::for_each(r.monitor.violations, count, &Violation::condition);
  }
  for (const Assumption& a : mission.assumptions) {
    count(a.watch.condition);
    std::ranges::for_each(a.watch.monitor.violations, count, &Violation::condition);
  }
  for (const Block& block : mission.blocks) {
    for (const Statement& s : block.statements) {
      count(s.value);
      std::ranges::for_each(s.values, count);
    }
  }
  countCases(mission.always);
  for (const State& s : mission.states) {
    for (const Activity* a : {&s.route, &s.profile}) {
      std::ranges::for_each(a->arguments, count);
      countCases(a->cases);
    }
    std::ranges::for_each(s.log, count, &LogItem::value);
    std::ranges::for_each(s.sampling, count, &Sampling::code);
    std::ranges::for_each(s.sampling, count, &Sampling::period);
    countCases(s.cases);
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
    for (uint32_t k = operandCount(e); k-- > 0;) {
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

std::vector<uint32_t> layOutBlocks(const Mission& mission) {
  constexpr uint32_t kNo = UINT32_MAX;
  std::vector<uint32_t> first(mission.blocks.size());
  std::vector<uint32_t> depth(mission.blocks.size(), 1);
  for (uint32_t i = 0; i < first.size(); ++i) {
    std::vector<uint32_t> nested;
    for (const Statement& s : mission.blocks[i].statements) {
      for (BlockId id : {s.then, s.otherwise}) {
        if (id.valid()) {
          nested.push_back(id.index);
          depth[i] = std::max(depth[i], depth[id.index] + 1);
        }
      }
    }
    uint32_t next = i;
    for (size_t k = nested.size(); k-- > 0 && next != kNo;) {
      next = nested[k] + 1 == next ? first[nested[k]] : kNo;
    }
    first[i] = depth[i] < kDeepest ? next : kNo;
  }
  return first;
}

}  // namespace glider::ir::text
