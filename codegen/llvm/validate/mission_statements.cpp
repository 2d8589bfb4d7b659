// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What statements mean (S1 to S4), and what is kept from tick to tick (B1 to B7, W, Y).

#include "codegen/llvm/validate/mission_functions.h"
#include "ir/core/pilot_name.h"
#include "ir/core/walk.h"
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
  if (id.valid()) {
    ir::forEachIn(mission, id, [&](const ir::Expr& expr) {
      if (expr.op == ir::Op::Sensor) {
        sensors.insert(expr.sensor.index);
      }
    });
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
    case ir::TemporalKind::Became:
    case ir::TemporalKind::Held:
    case ir::TemporalKind::AtLowest:
    case ir::TemporalKind::AtHighest:
    case ir::TemporalKind::Steepest:
    case ir::TemporalKind::AtSteepest:
    case ir::TemporalKind::Number:
      break;
  }
  CHECK(false, "not a window over a time or a stretch");
}

}  // namespace

void MissionFunctions::assign(Memory& memory, ir::VariableId variable, const z3::expr& value) {
  effects_.store(memory, effects_.places().variable(variable), value);
}

void MissionFunctions::note(Memory& memory, uint32_t kind, const std::string& text,
                            const std::vector<z3::expr>& values) {
  std::vector<z3::expr> all{effects_.word(kind), effects_.address(effects_.places().text(text))};
  all.insert(all.end(), values.begin(), values.end());
  effects_.command(memory, "gliderNote", all);
}

void MissionFunctions::run(Memory& memory, ir::BlockId block) {
  if (block.valid()) {
    for (const ir::Statement& statement : mission_[block].statements) {
      execute(memory, statement);
    }
  }
}

void MissionFunctions::execute(Memory& memory, const ir::Statement& statement) {
  std::vector<z3::expr> values;
  switch (statement.kind) {
    case ir::StatementKind::Set:
      return set(memory, statement);
    case ir::StatementKind::If:
      return choose(memory, statement);
    case ir::StatementKind::Log:
      for (const ir::ExprId value : statement.values) {
        values.push_back(expressions_.asNumber(memory, value));
      }
      return note(memory, kGliderNoteLog, statement.text, values);
    case ir::StatementKind::Command:
      values.push_back(context());
      for (const ir::ExprId value : statement.values) {
        values.push_back(expressions_.number(memory, value));
      }
      return code_.command(
          memory, std::string(ir::commands().at(static_cast<size_t>(statement.command)).symbol),
          values);
  }
}

/// S1.
void MissionFunctions::set(Memory& memory, const ir::Statement& statement) {
  const z3::expr value = expressions_.asNumber(memory, statement.value);
  Memory refused = memory;
  note(refused, kGliderNoteUnknownSet, ir::pilotName(mission_, statement.variable), {});
  assign(memory, statement.variable, value);
  memory = effects_.either(numbers().isKnown(value), memory, refused);
}

/// S2.
void MissionFunctions::choose(Memory& memory, const ir::Statement& statement) {
  const MissionExpressions::Value condition = expressions_.valueOf(memory, statement.value);
  Memory then = memory;
  run(then, statement.then);
  Memory otherwise = memory;
  run(otherwise, statement.otherwise);
  memory = effects_.either(condition.is_true, then,
                           effects_.either(condition.is_false, otherwise, memory));
}

void MissionFunctions::watch(Memory& memory, ir::TemporalId id, When when) {
  const ir::Temporal& temporal = mission_[id];
  if (ir::isWindow(temporal.kind)) {
    return advanceWindow(memory, id);
  }
  const auto slot = [&](uint32_t number) { return effects_.places().temporal(id, number); };
  const MissionExpressions::Value operand = expressions_.valueOf(memory, temporal.operand);
  const z3::expr before =
      numbers().equal(effects_.load(memory, slot(kBefore)), numbers().constant(1));
  const z3::expr turned =
      when == When::Start ? effects_.truth(false) : (operand.is_true && !before).simplify();
  const z3::expr unknown = numbers().unknown();
  const z3::expr truths[] = {numbers().constant(0), numbers().constant(1)};
  if (temporal.kind == ir::TemporalKind::Became) {  // B1, B2, B6, B7
    const z3::expr known = operand.is_true || operand.is_false;
    effects_.store(memory, slot(kValue),
                   z3::ite(known, z3::ite(turned, truths[1], truths[0]), unknown).simplify());
  } else {
    const z3::expr long_enough = held(memory, id, when, turned);
    effects_.store(
        memory, slot(kValue),
        z3::ite(operand.is_true, long_enough, z3::ite(operand.is_false, truths[0], unknown))
            .simplify());
  }
  effects_.store(memory, slot(kBefore), z3::ite(operand.is_true, truths[1], truths[0]).simplify());
}

/// B3 to B7: whether it has been true for long enough, as a number.
z3::expr MissionFunctions::held(Memory& memory, ir::TemporalId id, When when,
                                const z3::expr& turned) {
  const Address since = effects_.places().temporal(id, kSince);
  const z3::expr duration = expressions_.number(memory, mission_[id].duration);
  const z3::expr from = when == When::Start
                            ? time(memory)
                            : z3::ite(turned, time(memory), effects_.load(memory, since));
  effects_.store(memory, since, from.simplify());
  const z3::expr so_far = expressions_.since(memory, effects_.load(memory, since));
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
  return effects_.address(effects_.places().object("constant " + content));
}

void MissionFunctions::startWindow(Memory& memory, ir::TemporalId id) {
  const ir::Temporal& window = mission_[id];
  const Address slot = effects_.places().temporal(id, 0);
  if (window.leg == ir::Leg::None) {
    effects_.window(memory, "gliderWindowStart", slot, {shape(window), time(memory)});
  } else {
    effects_.window(memory,
                    ir::isOfSteepest(window.kind) ? "gliderSteepestStart" : "gliderLegStart", slot,
                    {time(memory)});
  }
}

/// W1, Y5.
z3::expr MissionFunctions::fresh(const Memory& memory, const ir::Temporal& window) {
  std::set<uint32_t> sensors;
  addSensors(mission_, window.operand, sensors);
  addSensors(mission_, window.duration, sensors);
  if (window.leg == ir::Leg::None) {
    addSensors(mission_, window.along, sensors);
  }
  z3::expr none_old = effects_.truth(true);
  z3::expr one_new = effects_.truth(sensors.empty());
  for (const uint32_t sensor : sensors) {
    const z3::expr age = expressions_.age(memory, {sensor});
    const z3::expr old =
        !numbers().isKnown(age) || numbers().less(numbers().constant(kFreshAge), age);
    none_old = none_old && !old;
    one_new = one_new || numbers().equal(age, numbers().constant(0));
  }
  return z3::ite(none_old && one_new, effects_.word(1), effects_.word(0)).simplify();
}

void MissionFunctions::advanceWindow(Memory& memory, ir::TemporalId id) {
  const ir::Temporal& window = mission_[id];
  const Address slot = effects_.places().temporal(id, 0);
  const z3::expr value = expressions_.number(memory, window.operand);
  if (window.leg == ir::Leg::None) {
    const z3::expr along =
        window.along.valid() ? expressions_.number(memory, window.along) : time(memory);
    return effects_.window(memory, "gliderWindowAdvance", slot,
                           {shape(window), time(memory), along, value, fresh(memory, window)});
  }
  const z3::expr other =
      window.duration.valid() ? expressions_.number(memory, window.duration) : value;
  const z3::expr phase = expressions_.number(memory, window.along);
  const bool of_operand = window.kind == ir::TemporalKind::Steepest;
  effects_.window(
      memory, ir::isOfSteepest(window.kind) ? "gliderSteepestAdvance" : "gliderLegAdvance", slot,
      {shape(window), time(memory), phase, of_operand ? value : other, of_operand ? other : value,
       fresh(memory, window)});
}

}  // namespace glider::codegen::validate
