// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/cone_of_influence.h"

#include "ir/core/ops.h"
#include "ir/prove/context/commands.h"

namespace glider::ir::prove {
namespace {

/// Grows the cone of influence to a fixpoint.
class ConeClosure {
 public:
  ConeClosure(const Mission& mission, bool vehicle) : m_(mission), seen_(mission.exprs.size()) {
    result_.vehicle = vehicle;
    result_.variables.assign(mission.variables.size(), false);
    result_.temporals.assign(mission.temporals.size(), false);
    result_.profiles.assign(mission.states.size(), false);
    result_.routes.assign(mission.states.size(), false);
  }

  ConeOfInfluence run(const std::vector<ExprId>& asked) {
    for (const ExprId id : asked) {
      read(id);
    }
    guards(m_.always);
    for (const State& state : m_.states) {
      guards(state.cases);
    }
    do {
      grown_ = false;
      initials();
      blocks();
      arguments(m_.always);
      for (uint32_t i = 0; i < m_.states.size(); ++i) {
        arguments(m_.states[i].cases);
        activity(m_.states[i].profile, result_.profiles, i);
        activity(m_.states[i].route, result_.routes, i);
      }
    } while (grown_);
    result_.expressions = seen_;
    return result_;
  }

 private:
  /// Adds what an expression reads.
  void read(ExprId id) {
    std::vector<ExprId> open{id};
    while (!open.empty()) {
      const ExprId next = open.back();
      open.pop_back();
      if (!next.valid() || seen_[next.index]) {
        continue;
      }
      seen_[next.index] = true;
      grown_ = true;
      const Expr& e = m_[next];
      open.insert(open.end(), e.operands.begin(), e.operands.end());
      if (e.variable.valid()) {
        result_.variables[e.variable.index] = true;
      }
      result_.state_time = result_.state_time || e.op == Op::StateTime;
      result_.resume_time = result_.resume_time || e.op == Op::ResumeTime;
      if (e.temporal.valid()) {
        result_.temporals[e.temporal.index] = true;
        const Temporal& temporal = m_[e.temporal];
        open.push_back(temporal.duration);
        result_.state_time = result_.state_time || isWindow(temporal.kind);
        if (!isWindow(temporal.kind)) {
          open.push_back(temporal.operand);
        }
      }
    }
  }

  void guards(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      read(c.guard);
    }
  }

  void initials() {
    for (size_t i = 0; i < m_.variables.size(); ++i) {
      if (result_.variables[i]) {
        read(m_.variables[i].initial);
      }
    }
  }

  void arguments(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        if (result_.variables[m_[c.target].parameters[i].index]) {
          read(c.arguments[i]);
        }
      }
    }
  }

  /// Whether a block sets a variable in the cone, or gives commands.
  bool matters(BlockId block) const {
    if (!block.valid()) {
      return false;
    }
    for (const Statement& s : m_[block].statements) {
      const bool here = s.kind == StatementKind::Set ? result_.variables[s.variable.index]
                        : s.kind == StatementKind::Command
                            ? result_.vehicle && isVertical(s.command)
                        : s.kind == StatementKind::If ? matters(s.then) || matters(s.otherwise)
                                                      : false;
      if (here) {
        return true;
      }
    }
    return false;
  }

  void blocks() {
    for (const Block& block : m_.blocks) {
      for (const Statement& s : block.statements) {
        if (s.kind == StatementKind::Set && result_.variables[s.variable.index]) {
          read(s.value);
        } else if (s.kind == StatementKind::If && (matters(s.then) || matters(s.otherwise))) {
          read(s.value);
        } else if (s.kind == StatementKind::Command && result_.vehicle && isVertical(s.command)) {
          for (const ExprId value : s.values) {
            read(value);
          }
        }
      }
    }
  }

  void activity(const Activity& activity, std::vector<bool>& relevant, uint32_t state) {
    const bool foreign = !m_[activity.behaviour].symbol.empty() && result_.vehicle;
    bool here = foreign || matters(activity.entry) ||
                (activity.done.valid() && result_.variables[activity.done.index]);
    for (const Case& c : activity.cases) {
      here = here || matters(c.action);
    }
    if (here) {
      relevant[state] = true;
      guards(activity.cases);
    }
  }

  const Mission& m_;
  std::vector<bool> seen_;
  ConeOfInfluence result_;
  bool grown_ = false;
};

}  // namespace

ConeOfInfluence relevanceFor(const Mission& mission, const std::vector<ExprId>& asked,
                             bool vehicle) {
  return ConeClosure(mission, vehicle).run(asked);
}

}  // namespace glider::ir::prove
