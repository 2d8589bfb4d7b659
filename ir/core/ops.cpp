// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/ops.h"

#include <algorithm>
#include <array>
#include <span>

namespace glider::ir {
namespace {

constexpr Type kBoolType{TypeKind::Bool, {}};
constexpr Type kNumber{TypeKind::Quantity, support::dimension::number};
constexpr Type kTimeType{TypeKind::Quantity, support::dimension::time};
constexpr Type kLength{TypeKind::Quantity, support::dimension::length};
constexpr Type kAngle{TypeKind::Quantity, support::dimension::angle};
constexpr Type kLatitude{TypeKind::Latitude, {}};
constexpr Type kLongitude{TypeKind::Longitude, {}};

std::optional<Type> quantity(std::optional<support::Dimension> dimension) {
  return dimension ? std::optional(Type{TypeKind::Quantity, *dimension}) : std::nullopt;
}

std::optional<Type> when(bool fits, Type type) {
  return fits ? std::optional(type) : std::nullopt;
}

/// The type of a call of a C function.
std::optional<Type> called(const Mission& mission, const Expr& expr) {
  const Function& function = mission[expr.use];
  if (operandCount(expr) != function.parameters.size()) {
    return std::nullopt;
  }
  for (size_t i = 0; i < function.parameters.size(); ++i) {
    if (mission[expr.operands.at(i)].type != function.parameters[i].type) {
      return std::nullopt;
    }
  }
  return function.result;
}

bool haveOneType(std::span<const Type> types) {
  return std::ranges::all_of(types, [&](Type type) { return type == types.front(); });
}

bool areNumbers(std::span<const Type> types) {
  return std::ranges::none_of(types, [](Type type) { return type.kind == TypeKind::Bool; });
}

bool areQuantities(std::span<const Type> types) {
  return std::ranges::all_of(types, [](Type type) { return type.kind == TypeKind::Quantity; });
}

bool arePlaces(std::span<const Type> types) {
  return types[0] == kLatitude && types[1] == kLongitude && types[2] == kLatitude &&
         types[3] == kLongitude;
}

bool areCourse(std::span<const Type> types) {
  return types[0] == kLatitude && types[1] == kLongitude && types[2] == kAngle &&
         types[3] == kLength;
}

bool areOfCtd(std::span<const Type> types) {
  using namespace support::dimension;
  return types[0] == Type{TypeKind::Quantity, conductivity} &&
         types[1] == Type{TypeKind::Quantity, temperature} &&
         types[2] == Type{TypeKind::Quantity, pressure};
}

/// The type of a watched truth value, or of a window.
std::optional<Type> watched(const Mission& mission, const Temporal& t) {
  if (!isWindow(t.kind)) {
    return kBoolType;
  }
  const Type value = mission[t.operand].type;
  if (value.kind == TypeKind::Bool) {
    return std::nullopt;
  }
  if (t.kind == TemporalKind::Number) {
    return Type{TypeKind::Quantity, support::dimension::number};
  }
  const bool steepest = t.kind == TemporalKind::Steepest;
  const ExprId over = steepest ? t.duration : t.along;
  const Type along = over.valid() ? mission[over].type : kTimeType;
  if (t.kind == TemporalKind::Slope || steepest) {
    const bool quantities = value.kind == TypeKind::Quantity && along.kind == TypeKind::Quantity;
    return quantities ? quantity(support::quotient(value.dimension, along.dimension))
                      : std::nullopt;
  }
  return value;
}

/// Whether `operands` have the types that an operation takes.
bool fit(Takes takes, std::span<const Type> operands) {
  switch (takes) {
    case Takes::Nothing:
      return true;
    case Takes::Numbers:
      return areNumbers(operands);
    case Takes::Alike:
      return areNumbers(operands) && haveOneType(operands);
    case Takes::Quantities:
      return areQuantities(operands);
    case Takes::AlikeQuantities:
      return areQuantities(operands) && haveOneType(operands);
    case Takes::Number:
    case Takes::Angle:
    case Takes::Truths:
      return operands.front() == operandType(takes) && haveOneType(operands);
    case Takes::Places:
      return arePlaces(operands);
    case Takes::Course:
      return areCourse(operands);
    case Takes::Ctd:
      return areOfCtd(operands);
    case Takes::Choice:
      return operands[0] == kBoolType && fit(Takes::Alike, operands.subspan(1));
  }
  CHECK(false, "operands without a rule");
}

std::optional<Type> quotientOf(Type a, Type b) {
  return areQuantities(std::array{a, b}) ? quantity(support::quotient(a.dimension, b.dimension))
                                         : when(a == b, kNumber);
}

/// The type of a result; `operands` fit.
std::optional<Type> given(Gives gives, const Mission& mission, const Expr& expr,
                          std::span<const Type> operands) {
  switch (gives) {
    case Gives::Own:
      return when(expr.type.kind != TypeKind::Bool, expr.type);
    case Gives::Truth:
      return kBoolType;
    case Gives::Number:
      return kNumber;
    case Gives::Time:
      return kTimeType;
    case Gives::Angle:
      return kAngle;
    case Gives::Length:
      return kLength;
    case Gives::Latitude:
      return kLatitude;
    case Gives::Longitude:
      return kLongitude;
    case Gives::Sensor:
      return mission[expr.sensor].type;
    case Gives::Variable:
      return mission[expr.variable].type;
    case Gives::Temporal:
      return watched(mission, mission[expr.temporal]);
    case Gives::Element:
      return mission[expr.table].type;
    case Gives::Call:
      return called(mission, expr);
    case Gives::Same:
      return operands.front();
    case Gives::Last:
      return operands.back();
    case Gives::Root:
      return quantity(support::squareRoot(operands[0].dimension));
    case Gives::Product:
      return quantity(support::product(operands[0].dimension, operands[1].dimension));
    case Gives::Quotient:
      return quotientOf(operands[0], operands[1]);
  }
  CHECK(false, "a type without a rule");
}

}  // namespace

bool isOrdering(Op op) {
  return op == Op::Less || op == Op::LessEqual || op == Op::Greater || op == Op::GreaterEqual;
}

Op negated(Op comparison) {
  switch (opIn<ComparisonOp>(comparison)) {
    case ComparisonOp::Less:
      return Op::GreaterEqual;
    case ComparisonOp::LessEqual:
      return Op::Greater;
    case ComparisonOp::Greater:
      return Op::LessEqual;
    case ComparisonOp::GreaterEqual:
      return Op::Less;
    case ComparisonOp::Equal:
      return Op::NotEqual;
    case ComparisonOp::NotEqual:
      return Op::Equal;
  }
  CHECK(false, "a comparison without an opposite");
}

Op mirrored(Op comparison) {
  switch (opIn<ComparisonOp>(comparison)) {
    case ComparisonOp::Less:
      return Op::Greater;
    case ComparisonOp::LessEqual:
      return Op::GreaterEqual;
    case ComparisonOp::Greater:
      return Op::Less;
    case ComparisonOp::GreaterEqual:
      return Op::LessEqual;
    case ComparisonOp::Equal:
    case ComparisonOp::NotEqual:
      return comparison;
  }
  CHECK(false, "a comparison without a mirror image");
}

bool isWindow(TemporalKind kind) {
  return kind != TemporalKind::Became && kind != TemporalKind::Held;
}

bool isOfSteepest(TemporalKind kind) {
  return kind == TemporalKind::Steepest || kind == TemporalKind::AtSteepest;
}

const OpInfo* findOp(std::string_view text) {
  auto found = std::ranges::find(kOps, text, &OpInfo::text);
  return found == kOps.end() ? nullptr : &*found;
}

uint32_t argumentCount(const Expr& call) {
  const auto end = std::ranges::find_if(call.operands, [](ExprId id) { return !id.valid(); });
  return static_cast<uint32_t>(end - call.operands.begin());
}

const std::vector<CommandInfo>& commands() {
  constexpr Type length = kLength, angle = kAngle, latitude = kLatitude, longitude = kLongitude,
                 volume = {TypeKind::Quantity, support::dimension::volume},
                 speed = {TypeKind::Quantity, support::dimension::speed};
  static const std::vector<CommandInfo> kCommands = {
#define PARAMETER(name, type) Parameter{#name, type},
#define COMMAND(name, text, symbol, ...) {Command::name, text, symbol, {__VA_ARGS__}},
#include "ir/core/commands.def"
#undef COMMAND
#undef PARAMETER
  };
  return kCommands;
}

std::string_view symbolOf(FunctionOp op) {
  switch (op) {
#define FUNCTION(name, text, operands, takes, gives, known, whole, symbol) \
  case FunctionOp::name:                                                   \
    return #symbol;
#include "ir/core/ops.def"
  }
  CHECK(false, "a function that the runtime does not have");
}

std::optional<Type> operandType(Takes takes) {
  switch (takes) {
    case Takes::Number:
      return kNumber;
    case Takes::Angle:
      return kAngle;
    case Takes::Truths:
      return kBoolType;
    case Takes::Nothing:
    case Takes::Numbers:
    case Takes::Alike:
    case Takes::Quantities:
    case Takes::AlikeQuantities:
    case Takes::Places:
    case Takes::Course:
    case Takes::Ctd:
    case Takes::Choice:
      break;
  }
  return std::nullopt;
}

std::optional<Type> resultType(const Mission& mission, const Expr& expr) {
  const OpInfo& op = opInfo(expr.op);
  std::array<Type, kMostOperands> all;
  for (uint32_t i = 0; i < op.operands; ++i) {
    all.at(i) = mission[expr.operands.at(i)].type;
  }
  const auto operands = std::span<const Type>(all).first(op.operands);
  return fit(op.takes, operands) ? given(op.gives, mission, expr, operands) : std::nullopt;
}

}  // namespace glider::ir
