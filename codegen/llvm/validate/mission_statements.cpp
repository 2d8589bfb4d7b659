// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What statements mean (S1 to S4), and what is kept from tick to tick (B1 to B7, W, Y).

#include "codegen/llvm/validate/mission_functions.h"
#include "ir/core/pilot_name.h"
#include "ir/core/window_shape.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/leg.h"
#include "runtime/abi/window.h"
#include "support/check.h"

#include <fmt/format.h>

#include <bit>
#include <set>

namespace glider::codegen::validate {
namespace {

// Slots of a watch: its value, whether its operand was true, since when.
constexpr uint32_t kValue = 0;
constexpr uint32_t kBefore = 1;
constexpr uint32_t kSince = 2;

/// W1, Y5: the greatest age of a reading that a window takes, s.
constexpr double kFreshAge = 6;

void addSensors(const ir::Mission& mission, ir::ExprId id, std::set<uint32_t>& sensors) {
  if (!id.valid()) {
    return;
  }
  std::set<uint32_t> parts{id.index};
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    const ir::Expr& expr = mission.exprs.at(*part);
    if (expr.op == ir::Op::Sensor) {
      sensors.insert(expr.sensor.index);
    }
    for (uint32_t i = 0; i < ir::operandCount(expr); ++i) {
      parts.insert(expr.operands.at(i).index);
    }
  }
}

/// The runtime's number of a window over a leg.
uint32_t legKind(ir::TemporalKind kind) {
  switch (kind) {
    case ir::TemporalKind::Mean:
      return kGliderLegMean;
    case ir::TemporalKind::Lowest:
      return kGliderLegLowest;
    case ir::TemporalKind::Highest:
      return kGliderLegHighest;
    case ir::TemporalKind::Spread:
      return kGliderLegSpread;
    case ir::TemporalKind::AtLowest:
      return kGliderLegAtLowest;
    case ir::TemporalKind::AtHighest:
      return kGliderLegAtHighest;
    case ir::TemporalKind::Steepest:
      return kGliderLegSteepest;
    case ir::TemporalKind::AtSteepest:
      return kGliderLegAtSteepest;
    case ir::TemporalKind::Number:
      return kGliderLegNumber;
    case ir::TemporalKind::Became:
    case ir::TemporalKind::Held:
    case ir::TemporalKind::Slope:
      break;
  }
  CHECK(false, "not a window over a leg");
}

/// The runtime's number of another window.
uint32_t windowKind(ir::TemporalKind kind) {
  switch (kind) {
    case ir::TemporalKind::Mean:
      return kGliderMean;
    case ir::TemporalKind::Lowest:
      return kGliderLowest;
    case ir::TemporalKind::Highest:
      return kGliderHighest;
    case ir::TemporalKind::Spread:
      return kGliderSpread;
    case ir::TemporalKind::Slope:
      return kGliderSlope;
    default:
      break;
  }
  CHECK(false, "not a window over a time or a stretch");
}

}  // namespace

void MissionFunctions::assign(Moment& moment, ir::VariableId variable, const z3::expr& value) {
  moments_.store(moment, moments_.places().variable(variable), value);
}

void MissionFunctions::note(Moment& moment, uint32_t kind, const std::string& text,
                            const std::vector<z3::expr>& values) {
  std::vector<z3::expr> all{moments_.word(kind), moments_.address(moments_.places().text(text))};
  all.insert(all.end(), values.begin(), values.end());
  moments_.command(moment, "gliderNote", all);
}

void MissionFunctions::run(Moment& moment, ir::BlockId block) {
  if (block.valid()) {
    for (const ir::Statement& statement : mission_[block].statements) {
      execute(moment, statement);
    }
  }
}

void MissionFunctions::execute(Moment& moment, const ir::Statement& statement) {
  std::vector<z3::expr> values;
  switch (statement.kind) {
    case ir::StatementKind::Set:
      return set(moment, statement);
    case ir::StatementKind::If:
      return choose(moment, statement);
    case ir::StatementKind::Log:
      for (const ir::ExprId value : statement.values) {
        values.push_back(expressions_.asNumber(moment, value));
      }
      return note(moment, kGliderNoteLog, statement.text, values);
    case ir::StatementKind::Command:
      values.push_back(context());
      for (const ir::ExprId value : statement.values) {
        values.push_back(expressions_.number(moment, value));
      }
      return code_.command(
          moment, std::string(ir::commands().at(static_cast<size_t>(statement.command)).symbol),
          values);
  }
}

/// S1.
void MissionFunctions::set(Moment& moment, const ir::Statement& statement) {
  const z3::expr value = expressions_.asNumber(moment, statement.value);
  Moment refused = moment;
  note(refused, kGliderNoteUnknownSet, ir::pilotName(mission_, statement.variable), {});
  assign(moment, statement.variable, value);
  moment = moments_.either(numbers().isKnown(value), moment, refused);
}

/// S2.
void MissionFunctions::choose(Moment& moment, const ir::Statement& statement) {
  const MissionExpressions::Value condition = expressions_.valueOf(moment, statement.value);
  Moment then = moment;
  run(then, statement.then);
  Moment otherwise = moment;
  run(otherwise, statement.otherwise);
  moment = moments_.either(condition.is_true, then,
                           moments_.either(condition.is_false, otherwise, moment));
}

void MissionFunctions::watch(Moment& moment, ir::TemporalId id, When when) {
  const ir::Temporal& temporal = mission_[id];
  if (ir::isWindow(temporal.kind)) {
    return advanceWindow(moment, id);
  }
  const auto slot = [&](uint32_t number) { return moments_.places().temporal(id, number); };
  const MissionExpressions::Value operand = expressions_.valueOf(moment, temporal.operand);
  const z3::expr before =
      numbers().equal(moments_.load(moment, slot(kBefore)), numbers().constant(1));
  const z3::expr turned =
      when == When::Start ? moments_.truth(false) : (operand.is_true && !before).simplify();
  const z3::expr unknown = numbers().unknown();
  const z3::expr truths[] = {numbers().constant(0), numbers().constant(1)};
  if (temporal.kind == ir::TemporalKind::Became) {  // B1, B2, B6, B7
    const z3::expr known = operand.is_true || operand.is_false;
    moments_.store(moment, slot(kValue),
                   z3::ite(known, z3::ite(turned, truths[1], truths[0]), unknown).simplify());
  } else {
    const z3::expr long_enough = held(moment, id, when, turned);
    moments_.store(
        moment, slot(kValue),
        z3::ite(operand.is_true, long_enough, z3::ite(operand.is_false, truths[0], unknown))
            .simplify());
  }
  moments_.store(moment, slot(kBefore), z3::ite(operand.is_true, truths[1], truths[0]).simplify());
}

/// B3 to B7: whether it has been true for long enough, as a number.
z3::expr MissionFunctions::held(Moment& moment, ir::TemporalId id, When when,
                                const z3::expr& turned) {
  const Address since = moments_.places().temporal(id, kSince);
  const z3::expr duration = expressions_.number(moment, mission_[id].duration);
  const z3::expr from = when == When::Start
                            ? time(moment)
                            : z3::ite(turned, time(moment), moments_.load(moment, since));
  moments_.store(moment, since, from.simplify());
  const z3::expr so_far = expressions_.since(moment, moments_.load(moment, since));
  const z3::expr long_enough = numbers().isKnown(so_far) && !numbers().less(so_far, duration);
  return z3::ite(numbers().isKnown(duration),
                 z3::ite(long_enough, numbers().constant(1), numbers().constant(0)),
                 numbers().unknown())
      .simplify();
}

/// The place of the constant that describes a window to the runtime: the fields of GliderLegShape
/// or GliderWindowShape in their order.
z3::expr MissionFunctions::shape(const ir::Temporal& window) {
  const auto bits = [](double number) {
    return fmt::format("{:x}", std::bit_cast<uint64_t>(number));
  };
  std::string content;
  if (window.leg != ir::Leg::None) {
    content = fmt::format("{{{},{},{},{},}}", bits(window.dive), bits(window.climb),
                          legKind(window.kind), window.leg == ir::Leg::Last ? 1 : 0);
  } else {
    const ir::WindowShape shape = ir::windowShape(window);
    content = fmt::format("{{{},{},{},{},{},0,}}", bits(shape.length), bits(shape.bin), shape.bins,
                          windowKind(shape.kind), shape.stretch ? 1 : 0);
  }
  return moments_.address(moments_.places().object("constant " + content));
}

void MissionFunctions::startWindow(Moment& moment, ir::TemporalId id) {
  const ir::Temporal& window = mission_[id];
  const Address slot = moments_.places().temporal(id, 0);
  if (window.leg == ir::Leg::None) {
    moments_.window(moment, "gliderWindowStart", slot, {shape(window), time(moment)});
  } else {
    moments_.window(moment,
                    ir::isOfSteepest(window.kind) ? "gliderSteepestStart" : "gliderLegStart", slot,
                    {time(moment)});
  }
}

/// W1, Y5.
z3::expr MissionFunctions::fresh(const Moment& moment, const ir::Temporal& window) {
  std::set<uint32_t> sensors;
  addSensors(mission_, window.operand, sensors);
  addSensors(mission_, window.duration, sensors);
  if (window.leg == ir::Leg::None) {
    addSensors(mission_, window.along, sensors);
  }
  z3::expr none_old = moments_.truth(true);
  z3::expr one_new = moments_.truth(sensors.empty());
  for (const uint32_t sensor : sensors) {
    const z3::expr age = expressions_.age(moment, {sensor});
    const z3::expr old =
        !numbers().isKnown(age) || numbers().less(numbers().constant(kFreshAge), age);
    none_old = none_old && !old;
    one_new = one_new || numbers().equal(age, numbers().constant(0));
  }
  return z3::ite(none_old && one_new, moments_.word(1), moments_.word(0)).simplify();
}

void MissionFunctions::advanceWindow(Moment& moment, ir::TemporalId id) {
  const ir::Temporal& window = mission_[id];
  const Address slot = moments_.places().temporal(id, 0);
  const z3::expr value = expressions_.number(moment, window.operand);
  if (window.leg == ir::Leg::None) {
    const z3::expr along =
        window.along.valid() ? expressions_.number(moment, window.along) : time(moment);
    return moments_.window(moment, "gliderWindowAdvance", slot,
                           {shape(window), time(moment), along, value, fresh(moment, window)});
  }
  const z3::expr other =
      window.duration.valid() ? expressions_.number(moment, window.duration) : value;
  const z3::expr phase = expressions_.number(moment, window.along);
  const bool of_operand = window.kind == ir::TemporalKind::Steepest;
  moments_.window(
      moment, ir::isOfSteepest(window.kind) ? "gliderSteepestAdvance" : "gliderLegAdvance", slot,
      {shape(window), time(moment), phase, of_operand ? value : other, of_operand ? other : value,
       fresh(moment, window)});
}

}  // namespace glider::codegen::validate
