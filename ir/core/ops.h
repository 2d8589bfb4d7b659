// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/truth.h"
#include "support/check.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace glider::ir {

/// What operations take, and where their values come from. A group of several operations has a list
/// of its own below.
enum class OpGroup : uint8_t {
  Constant,
  Truth,
  Sensor,
  Clock,
  Variable,
  Temporal,
  Age,
  Unary,     ///< of one number
  Binary,    ///< of two numbers
  Function,  ///< of numbers, computed by runtime/numbers
  Clamp,
  Select,
  Element,
  Call,
  Comparison,  ///< of two numbers
  Known,
  Logic  ///< of truth values
};

/// The types of operands that fit. Those of a Call are its function's.
enum class Takes : uint8_t {
  Nothing,
  Numbers,          ///< no truth values
  Alike,            ///< numbers of one type
  Quantities,       ///< numbers, but no latitudes or longitudes
  AlikeQuantities,  ///< of one type
  Number,           ///< plain numbers
  Angle,
  Places,  ///< latitude, longitude, latitude, longitude
  Course,  ///< latitude, longitude, angle, length
  Ctd,     ///< conductivity, temperature, pressure
  Truths,
  Choice  ///< a truth value, and two numbers of one type
};

/// The type of a result.
enum class Gives : uint8_t {
  Own,  ///< the expression's: a number
  Truth,
  Number,  ///< a plain one
  Time,
  Angle,
  Length,
  Latitude,
  Longitude,
  Sensor,  ///< that of the sensor, and so on
  Variable,
  Temporal,
  Element,
  Call,
  Same,  ///< that of the first operand
  Last,
  Root,
  Product,
  Quotient  ///< of two latitudes or longitudes a plain number
};

/// When a result is never unknown.
enum class KnownRule : uint8_t {
  Always,
  Operands,  ///< if no operand is unknown
  Bounded,   ///< the same, if it is too small to overflow
  Quotient,  ///< the same, if the divisor is also never 0
  Guarded,   ///< the same, and if one side checks that the other is known
  Choice,    ///< the same, and if the first choice is a sensor and the condition is whether it is
             ///< known
  Row,       ///< the same, if it is a whole number that the table has
  Variable,  ///< as for the variable
  Maybe      ///< nothing is known of it
};

/// When a number is whole and was not rounded.
enum class WholeRule : uint8_t {
  Constant,
  Variable,
  Operands,  ///< if the operands are
  Choice,    ///< if both choices are
  Rounds,    ///< always: rounding to whole numbers gives nothing else
  Broken     ///< nothing is known of it
};

/// Whether a number may be -0.
enum class ZeroRule : uint8_t {
  Constant,
  Plain,  ///< it is settled, or measured: never
  Signed
};

/// A row of ops.def.
struct OpInfo {
  Op op;
  std::string_view text;  ///< spelling in the text form
  uint32_t operands;      ///< of a Call none: see operandCount
  OpGroup group;
  Takes takes;
  Gives gives;
  KnownRule known;
  WholeRule whole;
  ZeroRule zero;
};

inline constexpr auto kOps = std::to_array<OpInfo>({
#define OP(name, text, operands, group, takes, gives, known, whole, zero) \
  {Op::name,      text,         operands,         OpGroup::group,         \
   Takes::takes,  Gives::gives, KnownRule::known, WholeRule::whole,       \
   ZeroRule::zero},
#include "ir/core/ops.def"
});

/// The row of `op`.
constexpr const OpInfo& opInfo(Op op) {
  return kOps.at(static_cast<size_t>(op));
}
constexpr OpGroup groupOf(Op op) {
  return opInfo(op).group;
}

// The groups of several operations, so that the compiler names the operations missing in a switch
// over a group: opIn.
enum class ClockOp : uint8_t {
#define CLOCK(name, ...) name = static_cast<uint8_t>(Op::name),
#include "ir/core/ops.def"
};
enum class UnaryOp : uint8_t {
#define UNARY(name, ...) name = static_cast<uint8_t>(Op::name),
#include "ir/core/ops.def"
};
enum class BinaryOp : uint8_t {
#define BINARY(name, ...) name = static_cast<uint8_t>(Op::name),
#include "ir/core/ops.def"
};
enum class FunctionOp : uint8_t {
#define FUNCTION(name, ...) name = static_cast<uint8_t>(Op::name),
#include "ir/core/ops.def"
};
enum class ComparisonOp : uint8_t {
#define COMPARISON(name, ...) name = static_cast<uint8_t>(Op::name),
#include "ir/core/ops.def"
};
enum class LogicOp : uint8_t {
#define LOGIC(name, ...) name = static_cast<uint8_t>(Op::name),
#include "ir/core/ops.def"
};

template <typename List>
inline constexpr OpGroup kGroup = OpGroup::Constant;
template <>
inline constexpr OpGroup kGroup<ClockOp> = OpGroup::Clock;
template <>
inline constexpr OpGroup kGroup<UnaryOp> = OpGroup::Unary;
template <>
inline constexpr OpGroup kGroup<BinaryOp> = OpGroup::Binary;
template <>
inline constexpr OpGroup kGroup<FunctionOp> = OpGroup::Function;
template <>
inline constexpr OpGroup kGroup<ComparisonOp> = OpGroup::Comparison;
template <>
inline constexpr OpGroup kGroup<LogicOp> = OpGroup::Logic;

/// `op`, which is in that group, as an element of the group's list.
template <typename List>
List opIn(Op op) {
  CHECK(groupOf(op) == kGroup<List>, "an operation of another group");
  return static_cast<List>(op);
}

/// The runtime's function (runtime/abi/glider_abi.h) that computes `op`.
std::string_view symbolOf(FunctionOp op);

/// The result of `op` for the truth values that `operand(0)` and, except for Not, `operand(1)`
/// give.
template <typename Operand>
Truth logical(LogicOp op, Operand operand) {
  switch (op) {
    case LogicOp::Not:
      return logicalNot(operand(0));
    case LogicOp::And:
      return logicalAnd(operand(0), operand(1));
    case LogicOp::Or:
      return logicalOr(operand(0), operand(1));
  }
  CHECK(false, "a word of logic without a meaning");
}

/// The row spelled `text`; null if there is none.
const OpInfo* findOp(std::string_view text);
/// The number of operations.
constexpr size_t opCount() {
  return kOps.size();
}
/// As many operands as a Call has.
uint32_t argumentCount(const Expr& call);
/// The number of operands of `expr`: those of its operation, or as many as a Call has.
inline uint32_t operandCount(const Expr& expr) {
  return expr.op == Op::Call ? argumentCount(expr) : opInfo(expr.op).operands;
}

/// Whether `op` is a comparison: Less to NotEqual.
constexpr bool isComparison(Op op) {
  return groupOf(op) == OpGroup::Comparison;
}
/// Whether `op` is a comparison by the order of numbers: Less to GreaterEqual.
bool isOrdering(Op op);
/// The comparison that is true exactly where `comparison` (Less to NotEqual) is false.
Op negated(Op comparison);
/// The comparison that is true of (b, a) exactly where `comparison` is true of (a, b).
Op mirrored(Op comparison);

/// Whether it is a window: a number, not a truth value.
bool isWindow(TemporalKind kind);
/// Whether it is the steepest slope over a leg, or where that was.
bool isOfSteepest(TemporalKind kind);

/// A row of commands.def.
struct CommandInfo {
  Command command;
  std::string_view text;    ///< spelling, in the language and in the text form
  std::string_view symbol;  ///< C function of runtime/abi/behaviour.h
  std::vector<Parameter> parameters;
};

/// The rows of commands.def, in the order of Command.
const std::vector<CommandInfo>& commands();

/// Whether it is a command to go down to a depth, at a pitch or at a speed; the same, up.
inline bool isDescent(Command command) {
  return command == Command::Descend || command == Command::DescendAt;
}
inline bool isAscent(Command command) {
  return command == Command::Ascend || command == Command::AscendAt;
}

/// The type that each operand must have; empty if `takes` leaves a choice, or has several.
std::optional<Type> operandType(Takes takes);

/// The type that `expr` must have in `mission`, given the types of its operands (or of its sensor
/// or variable), by the rules of its operation: Takes and Gives. Empty if the operands do not fit.
/// Operands, sensor, variable, temporal, table and use must be in range, and what a temporal
/// watches must precede `expr`.
std::optional<Type> resultType(const Mission& mission, const Expr& expr);

}  // namespace glider::ir
