// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/evidence/command_variables.h"

#include "ir/core/walk.h"
#include "ir/prove/context/commands.h"

namespace glider::ir::prove {
namespace {

class Closure {
 public:
  explicit Closure(const Mission& mission) : m_(mission), found_(mission.variables.size()) {}

  std::vector<bool> run() {
    for (const Block& block : m_.blocks) {
      for (const Statement& s : block.statements) {
        if (s.kind == StatementKind::Command && isVertical(s.command) && !s.values.empty()) {
          read(s.values.front());
        }
      }
    }
    do {
      grown_ = false;
      assigned();
    } while (grown_);
    return found_;
  }

 private:
  void read(ExprId id) {
    forEachIn(m_, id, [&](const Expr& e) {
      if (e.op == Op::Variable && !found_[e.variable.index]) {
        found_[e.variable.index] = true;
        grown_ = true;
      }
    });
  }

  /// Reads what variables that were found are given.
  void assigned() {
    for (size_t i = 0; i < m_.variables.size(); ++i) {
      if (found_[i] && m_.variables[i].initial.valid()) {
        read(m_.variables[i].initial);
      }
    }
    for (const Block& block : m_.blocks) {
      for (const Statement& s : block.statements) {
        if (s.kind == StatementKind::Set && found_[s.variable.index]) {
          read(s.value);
        }
      }
    }
    arguments(m_.always);
    for (const State& state : m_.states) {
      arguments(state.cases);
    }
  }

  void arguments(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        if (found_[m_[c.target].parameters[i].index]) {
          read(c.arguments[i]);
        }
      }
    }
  }

  const Mission& m_;
  std::vector<bool> found_;
  bool grown_ = false;
};

}  // namespace

std::vector<bool> commandVariables(const Mission& mission) {
  return Closure(mission).run();
}

}  // namespace glider::ir::prove
