// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_missions/random_expressions.h"

#include "ir/core/ops.h"
#include "support/check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace glider::random_missions {
namespace {

using ir::ExprId;
using ir::Op;
using ir::Type;
using ir::TypeKind;
namespace dimension = support::dimension;

using Limits = std::numeric_limits<double>;

constexpr Type quantityOf(support::Dimension of) {
  return {TypeKind::Quantity, of};
}
constexpr Type kNumber = quantityOf(dimension::number);
constexpr Type kLength = quantityOf(dimension::length);
constexpr Type kTime = quantityOf(dimension::time);
constexpr Type kSpeed = quantityOf(dimension::speed);

constexpr Type kAngle = quantityOf(dimension::angle);
constexpr Type kLatitudeType{TypeKind::Latitude, {}};
constexpr Type kLongitudeType{TypeKind::Longitude, {}};

constexpr Type kCompared[] = {kNumber,
                              kLength,
                              kTime,
                              kSpeed,
                              quantityOf(dimension::temperature),
                              quantityOf(dimension::angle),
                              {TypeKind::Latitude, {}},
                              {TypeKind::Longitude, {}}};

/// Where arithmetic goes wrong first.
constexpr double kSpecialNumbers[] = {0.0,
                                      -0.0,
                                      1.0,
                                      Limits::min(),
                                      -Limits::min(),
                                      Limits::denorm_min(),
                                      -Limits::denorm_min(),
                                      0x1.8p-1023,
                                      Limits::max(),
                                      -Limits::max(),
                                      1e-200,
                                      1e200,
                                      0x1.fffffffffffffp-1,
                                      1e22};

/// Of one number of a certain type, to a plain number.
std::vector<Op> functionsOfOneToNumber() {
  std::vector<Op> ops;
  for (const ir::OpInfo& row : ir::kOps) {
    if (row.group == ir::OpGroup::Function && row.operands == 1 && ir::operandType(row.takes) &&
        row.gives == ir::Gives::Number) {
      ops.push_back(row.op);
    }
  }
  return ops;
}

}  // namespace

ExprId ExpressionMaker::keep(ir::Expr e) {
  const std::optional<Type> type = ir::resultType(m_, e);
  CHECK(type.has_value(), "a random expression whose operands do not fit");
  e.type = *type;
  reads_.push_back(ir::readsOf(m_, e, reads_));
  m_.exprs.push_back(e);
  return {static_cast<uint32_t>(m_.exprs.size() - 1)};
}

ExprId ExpressionMaker::add(Op op, std::array<ExprId, ir::kMostOperands> operands,
                            ir::SensorId sensor) {
  ir::Expr e;
  e.op = op;
  e.operands = operands;
  e.sensor = sensor;
  return keep(e);
}

ExprId ExpressionMaker::plain(Type type, double value) {
  ir::Expr e;
  e.type = type;
  e.number = value;
  return keep(e);
}

ExprId ExpressionMaker::variable(ir::VariableId id) {
  ir::Expr e;
  e.op = Op::Variable;
  e.variable = id;
  return keep(e);
}

ExprId ExpressionMaker::logged() {
  constexpr Op kClocks[] = {Op::MissionTime, Op::StateTime, Op::ResumeTime};
  if (random_.chance(0.3)) {
    return add(random_.pick(kClocks), {});
  }
  const auto count = static_cast<uint32_t>(m_.sensors.size());
  return add(Op::Sensor, {}, {random_.below(count)});
}

bool ExpressionMaker::readable(ExprId id) const {
  const ir::Reads& reads = reads_[id.index];
  return (!reads.state.valid() || reads.state == scope_.state) &&
         reads.variables_end <= scope_.variables_end &&
         !(scope_.initial && reads.temporals_end > 0);
}

double ExpressionMaker::plainValue(Type type) {
  std::vector<double> thresholds;
  for (const ir::Sensor& s : m_.sensors) {
    if (s.type == type && s.encoding == ir::Encoding::Linear) {
      thresholds.push_back(s.to_si *
                           random_.uniform(std::max(s.lowest, -1e3), std::min(s.highest, 1e3)));
    }
  }
  if (!thresholds.empty() && random_.chance(0.7)) {
    return random_.pick(thresholds);
  }
  if (type == kTime) {
    return 4.0 * random_.between(0, 60);
  }
  const double largest = type.kind == TypeKind::Longitude  ? 180
                         : type.kind == TypeKind::Latitude ? 90
                                                           : 50;
  return random_.chance(0.5) ? std::round(random_.uniform(-largest, largest))
                             : random_.uniform(-largest, largest);
}

ExprId ExpressionMaker::constant(Type type) {
  const double value = random_.chance(0.12) ? random_.pick(kSpecialNumbers) : plainValue(type);
  return plain(type, std::isfinite(value) ? value : 1);  // a sensor may have a huge factor
}

std::optional<ExprId> ExpressionMaker::anyVariable(Type type) {
  std::vector<uint32_t> fitting;
  for (uint32_t i = 0; i < m_.variables.size() && i < scope_.variables_end; ++i) {
    const ir::Variable& v = m_.variables[i];
    if (v.type == type && (!v.owner.valid() || v.owner == scope_.state)) {
      fitting.push_back(i);
    }
  }
  return fitting.empty() ? std::nullopt : std::optional(variable({random_.pick(fitting)}));
}

ExprId ExpressionMaker::temporal(ir::Temporal t) {
  t.list = scope_.list;
  t.state = scope_.state;
  m_.temporals.push_back(t);
  ir::Expr e;
  e.op = Op::Temporal;
  e.temporal = {static_cast<uint32_t>(m_.temporals.size() - 1)};
  return keep(e);
}

/// `became` or `held`.
ExprId ExpressionMaker::watched(uint32_t depth) {
  ir::Temporal t;
  t.kind = random_.chance(0.5) ? ir::TemporalKind::Became : ir::TemporalKind::Held;
  t.operand = guard(depth);
  if (t.kind == ir::TemporalKind::Held) {
    t.duration = random_.chance(0.8) ? plain(kTime, 4.0 * random_.between(0, 10)) : leaf(kTime);
  }
  return temporal(t);
}

std::optional<ExprId> ExpressionMaker::window(Type type) {
  ir::Temporal t;
  constexpr ir::TemporalKind kKinds[] = {ir::TemporalKind::Mean, ir::TemporalKind::Lowest,
                                         ir::TemporalKind::Highest, ir::TemporalKind::Spread};
  t.kind = random_.pick(kKinds);
  t.length = random_.uniform(1, 60);
  if (type == kSpeed) {
    t.kind = ir::TemporalKind::Slope;
    t.operand = number(kLength, 1);
    return temporal(t);
  }
  t.operand = number(type, 1);
  if (random_.chance(0.3)) {
    return leg(t);
  }
  if (random_.chance(0.5)) {
    t.along = add(Op::Sensor, {}, {random_.below(m_.sensors.size())});
  }
  const ExprId first = temporal(t);
  if (!random_.chance(0.3)) {
    return first;
  }
  // Another that differs in nothing but what it runs along.
  const bool was_along = t.along.valid();
  t.along = was_along && random_.chance(0.4)
                ? ExprId{}
                : add(Op::Sensor, {}, {random_.below(m_.sensors.size())});
  return add(random_.chance(0.5) ? Op::Min : Op::Max, {first, temporal(t)});
}

/// A window over a leg; the ends of a sensor's range, which streams often hold, are the legs.
ExprId ExpressionMaker::leg(ir::Temporal t) {
  const uint32_t along = random_.below(m_.sensors.size());
  const ir::Sensor& sensor = m_.sensors[along];
  t.length = 0;
  t.leg = random_.chance(0.5) ? ir::Leg::This : ir::Leg::Last;
  t.along = add(Op::Sensor, {}, {along});
  const auto end = [&](double raw) {
    constexpr double kFarthest = 1e3;  // of streams
    const double reading = std::clamp(raw, -kFarthest, kFarthest) * sensor.to_si;
    return std::isfinite(reading) ? reading : 0;
  };
  t.dive = end(sensor.lowest);
  t.climb = random_.chance(0.7) ? end(sensor.highest) : t.dive;
  if (random_.chance(0.4)) {
    t.kind = random_.chance(0.5) ? ir::TemporalKind::AtLowest : ir::TemporalKind::AtHighest;
    t.duration = number(kLength, 1);
  } else if (random_.chance(0.4)) {
    return steepest(t);
  }
  return temporal(t);
}

/// The same for the steepest change of it with a length, in the type of the operand.
ExprId ExpressionMaker::steepest(ir::Temporal t) {
  t.duration = number(kLength, 1);
  if (m_[t.operand].type.kind != ir::TypeKind::Quantity || random_.chance(0.5)) {
    t.kind = ir::TemporalKind::AtSteepest;
    return temporal(t);
  }
  t.kind = ir::TemporalKind::Steepest;
  return add(Op::Multiply, {temporal(t), plain(kLength, random_.uniform(0, 2))});
}

/// A function is called although what it gives does not matter: `false && f()`.
std::optional<ExprId> ExpressionMaker::idleCall() {
  const auto made = call({TypeKind::Bool, {}}, 0);
  if (!made) {
    return std::nullopt;
  }
  const bool conjunction = random_.chance(0.5);
  const ExprId ruling = truth(!conjunction);
  const Op op = conjunction ? Op::And : Op::Or;
  return random_.chance(0.5) ? add(op, {ruling, *made}) : add(op, {*made, ruling});
}

void ExpressionMaker::unread() {
  if (const auto made = call({TypeKind::Bool, {}}, 0)) {
    ir::Temporal t;
    t.kind = random_.chance(0.5) ? ir::TemporalKind::Became : ir::TemporalKind::Held;
    t.operand = *made;
    if (t.kind == ir::TemporalKind::Held) {
      t.duration = plain(kTime, 4.0 * random_.between(0, 10));
    }
    t.list = scope_.list;
    t.state = scope_.state;
    m_.temporals.push_back(t);
  }
}

ExprId ExpressionMaker::leaf(Type type) {
  if (random_.chance(0.35)) {
    if (const auto variable = anyVariable(type)) {
      return *variable;
    }
  }
  if (type == kTime && random_.chance(0.6)) {
    constexpr Op kClocks[] = {Op::MissionTime, Op::StateTime, Op::ResumeTime, Op::Age};
    const Op op = random_.pick(kClocks);
    return add(op, {},
               op == Op::Age ? ir::SensorId{random_.below(m_.sensors.size())} : ir::SensorId{});
  }
  std::vector<uint32_t> fitting;
  for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
    if (m_.sensors[i].type == type) {
      fitting.push_back(i);
    }
  }
  if (!fitting.empty() && random_.chance(0.75)) {
    return add(Op::Sensor, {}, {random_.pick(fitting)});
  }
  return constant(type);
}

ExprId ExpressionMaker::product(Type type, uint32_t depth) {
  if (type == kLength && random_.chance(0.5)) {
    const ExprId speed = number(kSpeed, depth);
    return add(Op::Multiply, {speed, number(kTime, depth)});
  }
  const ExprId factor = number(kNumber, depth);
  return add(Op::Multiply, {factor, number(type, depth)});
}

ExprId ExpressionMaker::quotient(Type type, uint32_t depth) {
  if (type == kSpeed && random_.chance(0.5)) {
    const ExprId length = number(kLength, depth);
    return add(Op::Divide, {length, number(kTime, depth)});
  }
  if (type == kNumber && random_.chance(0.5)) {
    const ExprId length = number(kLength, depth);
    return add(Op::Divide, {length, number(kLength, depth)});
  }
  const ExprId dividend = number(type, depth);
  return add(Op::Divide, {dividend, number(kNumber, depth)});
}

ExprId ExpressionMaker::root(Type type, uint32_t depth) {
  if (type == kNumber) {
    return add(Op::Sqrt, {number(kNumber, depth)});
  }
  const ExprId a = number(type, depth);
  const ExprId b = number(type, depth);
  return add(Op::Sqrt, {add(Op::Multiply, {a, b})});
}

/// Of a CTD's measurements, likely ones.
ExprId ExpressionMaker::ofWater() {
  using namespace support::dimension;
  const auto measured = [&](support::Dimension dimension, double lowest, double highest) {
    return plain({TypeKind::Quantity, dimension}, random_.uniform(lowest, highest));
  };
  const ExprId cond = measured(conductivity, 0, 7);
  const ExprId temp = measured(temperature, -5, 40);
  return add(random_.chance(0.5) ? Op::Salinity : Op::Density,
             {cond, temp, measured(pressure, -1e5, 1e7)});
}

/// What runtime/numbers computes.
std::optional<ExprId> ExpressionMaker::geometry(Type type, uint32_t depth) {
  if (type.kind != TypeKind::Quantity) {
    const ExprId north = number(kLatitudeType, depth);
    const ExprId east = number(kLongitudeType, depth);
    const ExprId bearing = number(kAngle, depth);
    return add(type == kLatitudeType ? Op::OffsetLatitude : Op::OffsetLongitude,
               {north, east, bearing, number(kLength, depth)});
  }
  if (random_.chance(0.15)) {
    const ExprId whole = number(type, depth);
    return add(Op::Remainder, {whole, number(type, depth)});
  }
  if (type == kNumber && random_.chance(0.2)) {
    return ofWater();
  }
  if (type == kNumber) {
    static const std::vector<Op> ops = functionsOfOneToNumber();
    const Op op = random_.pick(ops);
    const Type taken = *ir::operandType(ir::opInfo(op).takes);
    return add(op, {number(taken, depth)});
  }
  if (type == kAngle && random_.chance(0.5)) {
    const Type of = random_.pick(std::array{kNumber, kLength});
    const ExprId y = number(of, depth);
    return add(Op::Atan2, {y, number(of, depth)});
  }
  if (type != kAngle && type != kLength) {
    return std::nullopt;
  }
  std::array<ExprId, ir::kMostOperands> operands;
  for (uint32_t i = 0; i < 4; ++i) {
    operands.at(i) = number(i % 2 == 0 ? kLatitudeType : kLongitudeType, depth);
  }
  return add(type == kAngle ? Op::Bearing : Op::Distance, operands);
}

/// A C function, in a use of its own or, at times, in one that another expression stands for too.
std::optional<ExprId> ExpressionMaker::call(Type type, uint32_t depth) {
  std::vector<uint32_t> fitting;
  for (uint32_t i = 0; i < m_.functions.size(); ++i) {
    if (m_.functions[i].result == type) {
      fitting.push_back(i);
    }
  }
  if (fitting.empty()) {
    return std::nullopt;
  }
  ir::Expr e;
  e.op = Op::Call;
  const ir::FunctionId function{random_.pick(fitting)};
  for (size_t i = 0; i < m_[function].parameters.size(); ++i) {
    const Type of = m_[function].parameters[i].type;
    e.operands.at(i) = of.kind == TypeKind::Bool ? guard(0) : number(of, depth);
  }
  std::vector<uint32_t> uses;
  for (uint32_t i = 0; i < m_.uses.size(); ++i) {
    if (m_.uses[i].function == function) {
      uses.push_back(i);
    }
  }
  if (!uses.empty() && random_.chance(0.3)) {
    e.use = {random_.pick(uses)};
  } else {
    m_.uses.push_back({function, {}});
    e.use = {static_cast<uint32_t>(m_.uses.size() - 1)};
  }
  return keep(e);
}

/// One of a few values by its number, which may be the number of none.
ExprId ExpressionMaker::element(Type type, uint32_t depth) {
  ir::Table table{type, {}};
  for (uint32_t i = random_.between(1, 6); i > 0; --i) {
    table.values.push_back(plainValue(type));
  }
  std::erase_if(table.values, [](double value) { return !std::isfinite(value); });
  if (table.values.empty()) {
    table.values.push_back(1);
  }
  ir::Expr e;
  e.op = Op::Element;
  e.table = {static_cast<uint32_t>(m_.tables.size())};
  m_.tables.push_back(std::move(table));
  e.operands[0] =
      random_.chance(0.4) ? plain(kNumber, random_.between(0, 6)) : number(kNumber, depth);
  return keep(e);
}

ExprId ExpressionMaker::valueFor(const ir::Variable& v, uint32_t depth) {
  if (v.type.kind == TypeKind::Bool) {
    return guard(depth);
  }
  if (v.lowest == -ir::Variable::kEndless) {
    return number(v.type, depth);
  }
  const ExprId value = number(v.type, depth);
  const ExprId lowest = plain(v.type, v.lowest);
  const ExprId highest = plain(v.type, v.highest);
  if (random_.chance(0.3)) {
    return add(Op::Min, {add(Op::Max, {value, lowest}), highest});
  }
  return add(Op::Clamp, {value, lowest, highest});
}

ExprId ExpressionMaker::number(Type type, uint32_t depth) {
  if (random_.chance(0.1)) {
    for (int tries = 0; tries < 8 && !m_.exprs.empty(); ++tries) {
      const ExprId old{random_.below(m_.exprs.size())};
      if (m_[old].type == type && readable(old)) {
        return old;
      }
    }
  }
  if (depth == 0 || random_.chance(0.3)) {
    return leaf(type);
  }
  if (!scope_.initial && random_.chance(0.05)) {
    if (const auto made = window(type)) {
      return *made;
    }
  }
  if (random_.chance(0.05)) {
    const ExprId condition = guard(0);
    const ExprId a = number(type, depth - 1);
    return add(Op::Select, {condition, a, number(type, depth - 1)});
  }
  if (random_.chance(0.05)) {
    return element(type, depth - 1);
  }
  if (random_.chance(0.08)) {
    if (const auto made = call(type, depth - 1)) {
      return *made;
    }
  }
  if (random_.chance(0.12)) {
    if (const auto made = geometry(type, depth - 1)) {
      return *made;
    }
  }
  constexpr Op kOps[] = {Op::Negate, Op::Abs,   Op::Add,      Op::Subtract, Op::Min,
                         Op::Max,    Op::Clamp, Op::Multiply, Op::Divide,   Op::Sqrt};
  const bool position = type.kind != TypeKind::Quantity;
  const Op op = kOps[random_.below(std::size(kOps) - (position ? 3 : 0))];
  if (op == Op::Multiply) {
    return product(type, depth - 1);
  }
  if (op == Op::Divide) {
    return quotient(type, depth - 1);
  }
  if (op == Op::Sqrt) {
    return root(type, depth - 1);
  }
  std::array<ExprId, ir::kMostOperands> operands;
  for (uint32_t i = 0; i < ir::opInfo(op).operands; ++i) {
    operands.at(i) = number(type, depth - 1);
  }
  return add(op, operands);
}

ExprId ExpressionMaker::comparison() {
  constexpr Op kOps[] = {Op::Less,         Op::LessEqual, Op::Greater,
                         Op::GreaterEqual, Op::Equal,     Op::NotEqual};
  // A type that a sensor has is likelier to make a guard that changes.
  const Type type = random_.chance(0.6) ? random_.pick(m_.sensors).type : random_.pick(kCompared);
  const ExprId left = random_.chance(0.6) ? leaf(type) : number(type, random_.between(1, 3));
  const ExprId right = random_.chance(0.6) ? constant(type) : number(type, 1);
  return add(random_.pick(kOps), {left, right});
}

ExprId ExpressionMaker::threshold() {
  constexpr Op kOps[] = {Op::Less,         Op::LessEqual, Op::Greater,
                         Op::GreaterEqual, Op::Equal,     Op::NotEqual};
  const ExprId watched = logged();
  if (random_.chance(0.05)) {
    return add(Op::Known, {watched});
  }
  const ExprId at = constant(m_[watched].type);
  const Op op = random_.pick(kOps);
  return random_.chance(0.2) ? add(op, {at, watched}) : add(op, {watched, at});
}

ExprId ExpressionMaker::thresholds() {
  ExprId guard = threshold();
  for (uint32_t more = random_.below(3); more > 0; --more) {
    guard = random_.chance(0.15) ? add(Op::Not, {guard}) : guard;
    const ExprId other = random_.chance(0.1) ? comparison() : threshold();
    guard = add(random_.chance(0.7) ? Op::And : Op::Or, {guard, other});
  }
  return guard;
}

ExprId ExpressionMaker::guard(uint32_t depth) {
  if (depth == 0 || random_.chance(0.35)) {
    if (random_.chance(0.04)) {
      return truth(random_.chance(0.5));
    }
    if (random_.chance(0.2)) {
      if (const auto variable = anyVariable({TypeKind::Bool, {}})) {
        return *variable;
      }
    }
    return random_.chance(0.08) ? add(Op::Known, {number(random_.pick(m_.sensors).type, 2)})
                                : comparison();
  }
  if (!scope_.initial && random_.chance(0.2)) {
    return watched(depth - 1);
  }
  if (random_.chance(0.03)) {
    if (const auto made = idleCall()) {
      return *made;
    }
  }
  if (random_.chance(0.08)) {
    if (const auto made = call({TypeKind::Bool, {}}, depth - 1)) {
      return *made;
    }
  }
  if (random_.chance(0.2)) {
    return add(Op::Not, {guard(depth - 1)});
  }
  const Op op = random_.chance(0.5) ? Op::And : Op::Or;
  const ExprId left = guard(depth - 1);
  return add(op, {left, guard(depth - 1)});
}

ExprId ExpressionMaker::since(Op clock, double seconds) {
  const ExprId now = add(clock, {});
  return add(Op::GreaterEqual, {now, plain(kTime, seconds)});
}

}  // namespace glider::random_missions
