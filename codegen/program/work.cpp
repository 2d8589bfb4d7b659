// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/program/work.h"

#include "ir/core/ops.h"

#include <set>
#include <vector>

namespace glider::codegen {
namespace {

/// Counts what one function is made from; a shared expression once.
class Work {
 public:
  explicit Work(const ir::Mission& mission) : m_(mission) {}

  [[nodiscard]] size_t count() const { return count_; }

  void add(ir::ExprId root) {
    std::vector<ir::ExprId> open{root};
    while (!open.empty()) {
      const ir::ExprId id = open.back();
      open.pop_back();
      if (!id.valid() || !seen_.insert(id.index).second) {
        continue;
      }
      ++count_;
      const ir::Expr& e = m_[id];
      for (uint32_t k = 0; k < ir::opInfo(e.op).operands; ++k) {
        open.push_back(e.operands.at(k));
      }
    }
  }

  void add(ir::BlockId root) {
    std::vector<ir::BlockId> open{root};
    while (!open.empty()) {
      const ir::BlockId id = open.back();
      open.pop_back();
      if (!id.valid()) {
        continue;
      }
      for (const ir::Statement& statement : m_[id].statements) {
        ++count_;
        add(statement.value);
        for (const ir::ExprId value : statement.values) {
          add(value);
        }
        open.push_back(statement.then);
        open.push_back(statement.otherwise);
      }
    }
  }

  void add(const std::vector<ir::Case>& cases) {
    for (const ir::Case& c : cases) {
      ++count_;
      add(c.guard);
      add(c.action);
    }
  }

 private:
  const ir::Mission& m_;
  std::set<uint32_t> seen_;
  size_t count_ = 1;
};

}  // namespace

size_t workOfProfileTick(const ir::Mission& mission, uint32_t state) {
  Work work(mission);
  work.add(mission.states[state].profile.cases);
  return work.count();
}

size_t workOfState(const ir::Mission& mission, uint32_t index) {
  const ir::State& state = mission.states[index];
  Work work(mission);
  work.add(state.entry);
  work.add(state.cases);
  work.add(state.profile.entry);
  work.add(state.route.entry);
  work.add(state.route.cases);
  return work.count();
}

}  // namespace glider::codegen
