// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/work.h"

#include "ir/core/walk.h"

#include <set>
#include <vector>

namespace glider::codegen {
namespace {

/// Counts the expressions of one function; a shared expression once.
class Work {
 public:
  explicit Work(const ir::Mission& mission) : m_(mission) {}

  [[nodiscard]] size_t count() const { return count_; }

  void add(ir::ExprId root) {
    if (root.valid()) {
      ir::forEachIn(m_, root,
                    [this](const ir::Expr& e) { count_ += seen_.insert(&e).second ? 1U : 0U; });
    }
  }

  void add(ir::BlockId block) {
    ir::forEachStatement(m_, block, [this](const ir::Statement& statement) {
      ++count_;
      add(statement.value);
      for (const ir::ExprId value : statement.values) {
        add(value);
      }
    });
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
  std::set<const ir::Expr*> seen_;
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
