// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/compact.h"

#include "ir/opt/references.h"

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
  void operator()(StateId&) {}

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
    for (ExprId& operand : expr.operands) {
      if (operand.valid()) {
        (*this)(operand);
      }
    }
    if (expr.table.valid()) {
      tables[expr.table.index] = true;
    }
    if (expr.use.valid()) {
      uses[expr.use.index] = true;
    }
    if (expr.temporal.valid()) {
      mark(expr.temporal.index);
    }
  }

  Mission& mission_;
  std::vector<ExprId> pending_exprs_;
  std::vector<BlockId> pending_blocks_;
};

/// Keeps the marked elements; returns the new number of each.
template <typename T>
std::vector<uint32_t> keep(std::vector<T>& elements, const std::vector<bool>& marked) {
  std::vector<uint32_t> numbers(elements.size(), UINT32_MAX);
  uint32_t count = 0;
  for (size_t i = 0; i < elements.size(); ++i) {
    if (marked[i]) {
      numbers[i] = count;
      if (count != i) {
        elements[count] = std::move(elements[i]);
      }
      ++count;
    }
  }
  elements.resize(count);
  return numbers;
}

/// Drops functions that no use calls: they need not be linked.
void dropUnusedFunctions(Mission& mission) {
  std::vector<bool> used(mission.functions.size());
  for (const FunctionUse& use : mission.uses) {
    used[use.function.index] = true;
  }
  const std::vector<uint32_t> numbers = keep(mission.functions, used);
  for (FunctionUse& use : mission.uses) {
    use.function.index = numbers[use.function.index];
  }
}

struct Renumber {
  std::vector<uint32_t> exprs;
  std::vector<uint32_t> blocks;

  void operator()(ExprId& id) const { id.index = exprs[id.index]; }
  void operator()(BlockId& id) const { id.index = blocks[id.index]; }
  void operator()(StateId&) const {}
};

}  // namespace

void compact(Mission& mission) {
  const Marker marked(mission);
  Renumber renumber{keep(mission.exprs, marked.exprs), keep(mission.blocks, marked.blocks)};
  const std::vector<uint32_t> temporals = keep(mission.temporals, marked.temporals);
  const std::vector<uint32_t> tables = keep(mission.tables, marked.tables);
  const std::vector<uint32_t> uses = keep(mission.uses, marked.uses);
  dropUnusedFunctions(mission);
  for (Expr& expr : mission.exprs) {
    for (ExprId& operand : expr.operands) {
      if (operand.valid()) {
        renumber(operand);
      }
    }
    if (expr.temporal.valid()) {
      expr.temporal.index = temporals[expr.temporal.index];
    }
    if (expr.table.valid()) {
      expr.table.index = tables[expr.table.index];
    }
    if (expr.use.valid()) {
      expr.use.index = uses[expr.use.index];
    }
  }
  References references(renumber);
  references.ofBody(mission);
  for (Block& block : mission.blocks) {
    references.of(block);
  }
  for (Temporal& temporal : mission.temporals) {
    references.of(temporal);
  }
  for (Variable& variable : mission.variables) {
    references.of(variable);
  }
}

}  // namespace glider::ir::opt
