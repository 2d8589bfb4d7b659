// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/compact.h"

#include "ir/core/references.h"
#include "ir/opt/keep.h"

#include <vector>

namespace glider::ir::opt {
namespace {

/// For each expression, whether a C function is called in it.
std::vector<bool> callsOf(const Mission& mission) {
  std::vector<bool> calls(mission.exprs.size());
  for (uint32_t i = 0; i < calls.size(); ++i) {
    const Expr& expr = mission.exprs[i];
    calls[i] = expr.op == Op::Call;
    for (const ExprId operand : expr.operands) {
      calls[i] = calls[i] || (operand.valid() && calls[operand.index]);
    }
  }
  return calls;
}

/// Marks what can be reached from the mission's body and variables.
class Marker {
 public:
  explicit Marker(Mission& mission)
      : exprs(mission.exprs.size()),
        blocks(mission.blocks.size()),
        temporals(mission.temporals.size()),
        tables(mission.tables.size()),
        uses(mission.uses.size()),
        mission_(mission) {
    References references(*this);
    references.ofBody(mission);
    for (Variable& variable : mission.variables) {
      references.of(variable);
    }
    markWatchedCalls();
    while (!pending_exprs_.empty() || !pending_blocks_.empty()) {
      follow(references);
    }
  }

  void operator()(ExprId& id) {
    if (!exprs[id.index]) {
      exprs[id.index] = true;
      pending_exprs_.push_back(id);
    }
  }
  void operator()(BlockId& id) {
    if (!blocks[id.index]) {
      blocks[id.index] = true;
      pending_blocks_.push_back(id);
    }
  }
  void operator()(TemporalId& id) { mark(id.index); }
  void operator()(TableId& id) { tables[id.index] = true; }
  void operator()(UseId& id) { uses[id.index] = true; }

  std::vector<bool> exprs;
  std::vector<bool> blocks;
  std::vector<bool> temporals;
  std::vector<bool> tables;
  std::vector<bool> uses;

 private:
  /// A temporal's operand is evaluated on every tick, even if the temporal is not used: the
  /// functions in it are called.
  void markWatchedCalls() {
    const std::vector<bool> calls = callsOf(mission_);
    for (size_t i = 0; i < mission_.temporals.size(); ++i) {
      Temporal& t = mission_.temporals[i];
      const bool calling =
          calls[t.operand.index] || (t.duration.valid() && calls[t.duration.index]);
      if (calling && (t.list == ListKind::Always || t.state.valid())) {
        mark(i);
      }
    }
  }

  void mark(size_t temporal) {
    if (!temporals[temporal]) {
      temporals[temporal] = true;
      References<Marker>(*this).of(mission_.temporals[temporal]);
    }
  }

  void follow(References<Marker>& references) {
    if (!pending_blocks_.empty()) {
      Block& block = mission_.blocks[pending_blocks_.back().index];
      pending_blocks_.pop_back();
      references.of(block);
      return;
    }
    Expr& expr = mission_.exprs[pending_exprs_.back().index];
    pending_exprs_.pop_back();
    references.of(expr);
  }

  Mission& mission_;
  std::vector<ExprId> pending_exprs_;
  std::vector<BlockId> pending_blocks_;
};

/// Drops functions that no use calls: they need not be linked.
void dropUnusedFunctions(Mission& mission) {
  std::vector<bool> used(mission.functions.size());
  for (const FunctionUse& use : mission.uses) {
    used[use.function.index] = true;
  }
  const std::vector<uint32_t> numbers = keep(mission.functions, used);
  const auto renumber = [&](FunctionId& id) { id.index = numbers[id.index]; };
  References(renumber).of(mission);
}

struct Renumber {
  std::vector<uint32_t> exprs;
  std::vector<uint32_t> blocks;
  std::vector<uint32_t> temporals;
  std::vector<uint32_t> tables;
  std::vector<uint32_t> uses;

  void operator()(ExprId& id) const { id.index = exprs[id.index]; }
  void operator()(BlockId& id) const { id.index = blocks[id.index]; }
  void operator()(TemporalId& id) const { id.index = temporals[id.index]; }
  void operator()(TableId& id) const { id.index = tables[id.index]; }
  void operator()(UseId& id) const { id.index = uses[id.index]; }
};

}  // namespace

void compact(Mission& mission) {
  const Marker marked(mission);
  const Renumber renumber{keep(mission.exprs, marked.exprs), keep(mission.blocks, marked.blocks),
                          keep(mission.temporals, marked.temporals),
                          keep(mission.tables, marked.tables), keep(mission.uses, marked.uses)};
  References(renumber).of(mission);
  dropUnusedFunctions(mission);
}

}  // namespace glider::ir::opt
