// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Every operation on every pair of awkward operands, on every board, against ir/eval.

#include "ir/core/ops.h"
#include "tests/differential/judge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

namespace glider::differential {
namespace {

using ir::ExprId;
using ir::Op;
using Limits = std::numeric_limits<double>;

/// Ends of the range, values whose products fall just under the smallest normal number (where a 486
/// rounds twice), values that do not come out even in binary, unknown.
const std::vector<double> kOperands{0.0,
                                    -0.0,
                                    1.0,
                                    -1.0,
                                    3.0,
                                    0.1,
                                    -1.0 / 3.0,
                                    6.5e7,
                                    0x1.fffffffffffffp-1,
                                    1.0 - 0x3p-53,
                                    1.0 - 0x5p-53,
                                    Limits::min(),
                                    -Limits::min(),
                                    0x1.0000000000001p-1022,
                                    0x1.0000000000002p-1022,
                                    0x1p-511,
                                    -0x1.7p-512,
                                    0x1.6a09e667f3bcdp-511,
                                    Limits::max(),
                                    -Limits::max(),
                                    0x1p512,
                                    1.3407807929942597e154,
                                    1e-300,
                                    1e300,
                                    Limits::quiet_NaN()};

ir::Sensor plainSensor(uint16_t id) {
  ir::Sensor sensor;
  sensor.name = sensor.vehicle_name = std::string(1, static_cast<char>('a' + id));
  sensor.id = id;
  sensor.lowest = -Limits::max();
  sensor.highest = Limits::max();
  sensor.stale_after_s = 1e9;
  return sensor;
}

ir::Behaviour recorder(ir::BehaviourKind kind) {
  const bool profile = kind == ir::BehaviourKind::Profile;
  ir::Behaviour behaviour;
  behaviour.name = profile ? "p" : "r";
  behaviour.symbol = profile ? "gliderProfileRecord" : "gliderRouteRecord";
  behaviour.kind = kind;
  behaviour.parameters.resize(profile ? 4 : 3);
  for (size_t i = 0; i < behaviour.parameters.size(); ++i) {
    behaviour.parameters[i].name = fmt::format("x{}", i);
  }
  return behaviour;
}

/// Makes a mission of one state that reads three sensors.
class Maker {
 public:
  Maker() {
    mission_.name = "operations";
    mission_.platform = "slocum";
    mission_.behaviours = {recorder(ir::BehaviourKind::Profile),
                           recorder(ir::BehaviourKind::Route)};
    for (uint16_t i = 0; i < operands_.size(); ++i) {
      mission_.sensors.push_back(plainSensor(i));
      ir::Expr sensor;
      sensor.op = Op::Sensor;
      sensor.sensor = {i};
      operands_.at(i) = add(sensor);
    }
    const ExprId a = operands_[0];
    ir::State& state = mission_.states.emplace_back();
    state.name = "s";
    state.profile.behaviour = {0};
    state.profile.arguments = {a, a, a, a};
    state.route.behaviour = {1};
    state.route.arguments = {a, a, a};
  }

  ExprId operation(Op op, const std::array<ExprId, 3>& operands) {
    ir::Expr expr;
    expr.op = op;
    std::copy_n(operands.begin(), ir::opInfo(op).operands, expr.operands.begin());
    return add(expr);
  }
  ExprId operation(Op op) { return operation(op, operands_); }
  /// One of numbers of any type, or of angles.
  ExprId function(const ir::OpInfo& info) {
    std::array<ExprId, 3> operands = operands_;
    if (info.takes == ir::Takes::Angle) {
      for (ExprId& operand : operands) {
        operand = operation(Op::Multiply, {operand, radian(), {}});
      }
    }
    return operation(info.op, operands);
  }
  /// Of the table that the first operand gives the number of a value in.
  ExprId element(ir::TableId table) {
    ir::Expr expr;
    expr.op = Op::Element;
    expr.operands[0] = operands_[0];
    expr.table = table;
    return add(expr);
  }
  ExprId sensor(size_t i) const { return operands_.at(i); }
  ExprId radian() {
    ir::Expr expr;
    expr.number = 1;
    expr.type.dimension = support::dimension::angle;
    return add(expr);
  }
  ir::State& state() { return mission_.states.front(); }
  ir::Mission& mission() { return mission_; }

 private:
  ExprId add(ir::Expr expr) {
    if (const auto type = ir::resultType(mission_, expr)) {
      expr.type = *type;
    }
    mission_.exprs.push_back(expr);
    return {static_cast<uint32_t>(mission_.exprs.size() - 1)};
  }

  ir::Mission mission_;
  std::array<ExprId, 3> operands_;
};

/// All numeric operations, as values of a `log` in each tick.
ir::Mission numbers() {
  Maker maker;
  ir::Statement log;
  log.kind = ir::StatementKind::Log;
  log.text = "operations";
  for (const Op op : {Op::Negate, Op::Abs, Op::Sqrt, Op::Add, Op::Subtract, Op::Multiply,
                      Op::Divide, Op::Min, Op::Max, Op::Clamp}) {
    log.values.push_back(maker.operation(op));
  }
  for (const ir::OpInfo& function : ir::kOps) {
    if (function.group == ir::OpGroup::Function && function.takes != ir::Takes::Places &&
        function.takes != ir::Takes::Course && function.takes != ir::Takes::Ctd) {
      log.values.push_back(maker.function(function));
    }
  }
  const ExprId a = maker.sensor(0);
  maker.mission().tables = {{{}, {5, -7, 1e300}}};
  log.values.push_back(maker.element({0}));
  const ExprId less = maker.operation(Op::Less);
  log.values.push_back(maker.operation(Op::Select, {less, a, maker.sensor(2)}));
  maker.mission().blocks.push_back({{log}});
  ir::Case& each_tick = maker.state().cases.emplace_back();
  each_tick.guard = maker.operation(Op::True);
  each_tick.action = {0};
  return maker.mission();
}

/// A truth value: case 0 fires if it is true, case 1 if it is false, none if it is unknown.
ir::Mission truth(Op op) {
  Maker maker;
  const bool logical = op == Op::And || op == Op::Or || op == Op::Not;
  std::array<ExprId, 3> operands;
  if (logical) {
    const ExprId equal = maker.operation(Op::Equal);
    operands = {maker.operation(Op::Less), equal, {}};
  }
  const ExprId guard = logical ? maker.operation(op, operands) : maker.operation(op);
  const ExprId negation = maker.operation(Op::Not, {guard, {}, {}});
  for (const ExprId id : {guard, negation}) {
    ir::Case& added = maker.state().cases.emplace_back();
    added.guard = id;
  }
  return maker.mission();
}

std::vector<random_missions::StreamTick> allPairs() {
  std::vector<random_missions::StreamTick> stream;
  for (size_t i = 0; i < kOperands.size(); ++i) {
    for (size_t j = 0; j < kOperands.size(); ++j) {
      const double third = kOperands[(7 * i + 3 * j) % kOperands.size()];
      stream.push_back({4.0 * static_cast<double>(stream.size()),
                        {{{0}, kOperands[i]}, {{1}, kOperands[j]}, {{2}, third}}});
    }
  }
  return stream;
}

class OperationsJudged : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(OperationsJudged, AgreeWithEval) {
  std::vector<Trial> trials{{"numeric operations", numbers(), 0, allPairs(), {}}};
  for (const Op op : {Op::Less, Op::LessEqual, Op::Greater, Op::GreaterEqual, Op::Equal,
                      Op::NotEqual, Op::Known, Op::Not, Op::And, Op::Or}) {
    trials.push_back({fmt::format("`{}`", ir::opInfo(op).text), truth(op), 0, allPairs(), {}});
  }
  const auto [board, level] = GetParam();
  EXPECT_EQ(judge(trials, board, level), "");
}

INSTANTIATE_TEST_SUITE_P(Boards, OperationsJudged,
                         testing::Combine(testing::Values("host", "ts7800", "ts5500", "pizero2",
                                                          "cm4"),
                                          testing::Values(0, 1, 2, 3)),
                         [](const auto& param) {
                           return fmt::format("{}_O{}", std::get<0>(param.param),
                                              std::get<1>(param.param));
                         });

}  // namespace
}  // namespace glider::differential
