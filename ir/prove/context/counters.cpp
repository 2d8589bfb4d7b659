// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/counters.h"

#include "ir/core/ops.h"
#include "ir/core/types.h"
#include "ir/core/walk.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// More than these are not worth a question.
constexpr size_t kMostFree = 400;

class CounterMission {
 public:
  explicit CounterMission(const Mission& mission)
      : result_(mission), counts_(countersOf(mission)) {}

  std::optional<Mission> run() {
    for (Case& c : result_.always) {
      c.guard = loosened(c.guard);
    }
    result_.always_table = {};
    for (State& state : result_.states) {
      for (Case& c : state.cases) {
        c.guard = loosened(c.guard);
      }
      state.table = {};
    }
    return kept_ && free_ <= kMostFree ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  /// Variables of the mission whose values are computed from such variables, parameters and
  /// constants alone.
  static std::vector<bool> countersOf(const Mission& mission) {
    std::vector<bool> counts;
    for (const Variable& variable : mission.variables) {
      counts.push_back(variable.kind == VariableKind::Parameter ||
                       variable.kind == VariableKind::Mission);
    }
    for (bool shrunk = true; std::exchange(shrunk, false);) {
      const auto look = [&](VariableId variable, ExprId value) {
        if (counts[variable.index] && value.valid() && !isCounted(mission, value, counts)) {
          counts[variable.index] = false;
          shrunk = true;
        }
      };
      for (uint32_t i = 0; i < mission.variables.size(); ++i) {
        look({i}, mission.variables[i].initial);
      }
      for (const Block& block : mission.blocks) {
        for (const Statement& s : block.statements) {
          if (s.kind == StatementKind::Set) {
            look(s.variable, s.value);
          }
        }
      }
    }
    return counts;
  }

  static bool isCounted(const Mission& mission, ExprId root, const std::vector<bool>& counts) {
    return !anyIn(mission, root, [&](const Expr& e) {
      switch (groupOf(e.op)) {
        case OpGroup::Variable:
          return !counts[e.variable.index];
        case OpGroup::Sensor:
        case OpGroup::Age:
        case OpGroup::Clock:
        case OpGroup::Temporal:
        case OpGroup::Call:
        case OpGroup::Element:
        case OpGroup::Function:
          return true;
        case OpGroup::Constant:
        case OpGroup::Truth:
        case OpGroup::Unary:
        case OpGroup::Binary:
        case OpGroup::Clamp:
        case OpGroup::Select:
        case OpGroup::Comparison:
        case OpGroup::Known:
        case OpGroup::Logic:
          return false;
      }
      return true;
    });
  }

  /// The conjuncts that only count, and anything for the others.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the condition is written
  ExprId loosened(ExprId guard) {
    const Expr& e = result_[guard];
    if (isCounted(result_, guard, counts_)) {
      kept_ = true;
      return guard;
    }
    if (e.op != Op::And) {
      return anything(guard);
    }
    const auto [left, right] = std::pair(e.operands[0], e.operands[1]);
    Expr both = e;
    both.operands[0] = loosened(left);
    both.operands[1] = loosened(right);
    return add(std::move(both));
  }

  /// A condition that may be true, false or unknown on each tick.
  ExprId anything(ExprId instead) {
    const Type number = plainNumber();
    const SensorId sensor{static_cast<uint32_t>(result_.sensors.size())};
    Sensor free;
    free.name = free.symbol = fmt::format("anything {}", free_++);
    free.vehicle_name = free.name;
    free.id = kFirstOwnSensor;
    free.type = number;
    free.lowest = -1;
    free.highest = 1;
    free.stale_after_s = 1;
    result_.sensors.push_back(std::move(free));
    const auto made = [&](Op op, const Type& type) {
      Expr e;
      e.op = op;
      e.type = type;
      e.range = result_[instead].range;
      return e;
    };
    Expr reading = made(Op::Sensor, number);
    reading.sensor = sensor;
    Expr positive = made(Op::Greater, boolean());
    positive.operands[0] = add(std::move(reading));
    positive.operands[1] = add(made(Op::Constant, number));
    return add(std::move(positive));
  }

  ExprId add(Expr e) {
    result_.exprs.push_back(std::move(e));
    return {static_cast<uint32_t>(result_.exprs.size() - 1)};
  }

  Mission result_;
  std::vector<bool> counts_;
  size_t free_ = 0;
  bool kept_ = false;
};

}  // namespace

std::optional<Mission> onlyCounters(const Mission& mission) {
  return CounterMission(mission).run();
}

}  // namespace glider::ir::prove
