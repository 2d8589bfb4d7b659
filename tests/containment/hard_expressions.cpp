// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/containment/hard_expressions.h"

#include "ir/core/ops.h"

#include <fmt/format.h>

namespace glider::containment {
namespace {

using ir::Op;

constexpr Kind kMeasured[] = {Kind::Number, Kind::Length, Kind::Time, Kind::Angle};

bool isPlace(Kind kind) {
  return kind == Kind::Latitude || kind == Kind::Longitude;
}

constexpr Op kAll[] = {
#define OP(name, ...) Op::name,
#include "ir/core/ops.def"
};

}  // namespace

std::string typeText(Kind kind) {
  constexpr const char* kWords[] = {"bool",  "number",   "length",   "time",
                                    "angle", "latitude", "longitude"};
  return kWords[static_cast<size_t>(kind)];
}

Kind HardExpressions::measured() {
  return random_.pick(kMeasured);
}

std::string HardExpressions::constant(Kind kind) {
  constexpr double kNumbers[] = {0, 1, 2, 3, -1, 0.5, 0.1, 7, 1e6};
  constexpr double kLengths[] = {0, 1, 2, 5, 30, 30.1, 90, -2, 200};
  constexpr double kTimes[] = {0, 4, 19, 20, 21, 60, 300, 301, 900, 3600, -5};
  constexpr double kAngles[] = {0, 0.4, 0.1, 3.141592653589793, -1, 6.5};
  constexpr double kLatitudes[] = {39, 39.1, 39.25, -39, 89.9};
  constexpr double kLongitudes[] = {2.5, 2.6, 3.1, -179.9, 180};
  switch (kind) {
    case Kind::Truth:
      return random_.chance(0.5) ? "true" : "false";
    case Kind::Number:
      return fmt::format("{}", random_.pick(kNumbers));
    case Kind::Length:
      return fmt::format("{}:length", random_.pick(kLengths));
    case Kind::Time:
      return fmt::format("{}:time", random_.pick(kTimes));
    case Kind::Angle:
      return fmt::format("{}:angle", random_.pick(kAngles));
    case Kind::Latitude:
      return fmt::format("{}:latitude", random_.pick(kLatitudes));
    case Kind::Longitude:
      return fmt::format("{}:longitude", random_.pick(kLongitudes));
  }
  return {};
}

std::optional<std::string> HardExpressions::named(Kind kind, const char* word) {
  std::vector<const Named*> found;
  for (const Named& n : named_) {
    if (n.kind == kind && n.text.starts_with(word) && (!n.state || n.state == state_) &&
        (!n.list || n.list == list_)) {
      found.push_back(&n);
    }
  }
  return found.empty() ? std::nullopt : std::optional(random_.pick(found)->text);
}

std::string HardExpressions::plain(Kind kind) {
  return random_.chance(0.5) ? named(kind, "(var").value_or(constant(kind)) : constant(kind);
}

std::string HardExpressions::operation(Op op, const std::vector<Kind>& operands, uint32_t depth) {
  std::string text = fmt::format("({}", ir::opInfo(op).text);
  for (const Kind kind : operands) {
    text += " " + of(kind, depth == 0 ? 0 : depth - 1);
  }
  return text + ")";
}

std::string HardExpressions::of(Kind kind, uint32_t depth) {
  for (int tries = 0; tries < 200; ++tries) {
    const Op op = random_.pick(kAll);
    if (depth == 0 && ir::opInfo(op).operands > 0) {
      continue;
    }
    if (auto text = made(op, kind, depth)) {
      return *text;
    }
  }
  return constant(kind);
}

std::string HardExpressions::anything(uint32_t depth) {
  return of(random_.chance(0.2) ? Kind::Truth : measured(), depth);
}

std::optional<std::string> HardExpressions::leaf(Op op, Kind kind) {
  constexpr const char* kLengths[] = {"depth", "altitude", "ping"};
  switch (kind) {
    case Kind::Number:
      return op == Op::Sensor ? std::optional("(sensor count)") : std::nullopt;
    case Kind::Length:
      return op == Op::Sensor ? std::optional(fmt::format("(sensor {})", random_.pick(kLengths)))
                              : std::nullopt;
    case Kind::Time:
      return op == Op::Sensor ? "(sensor gap)" : "(age altitude)";
    case Kind::Angle:
      return op == Op::Sensor ? std::optional("(sensor heading)") : std::nullopt;
    case Kind::Latitude:
      return op == Op::Sensor ? std::optional("(sensor lat)") : std::nullopt;
    case Kind::Longitude:
      return op == Op::Sensor ? std::optional("(sensor lon)") : std::nullopt;
    case Kind::Truth:
      break;
  }
  return std::nullopt;
}

/// Every function has its way here: a new one does not compile without.
std::optional<std::string> HardExpressions::function(Op op, Kind kind, uint32_t depth) {
  const auto when = [&](Kind gives, const std::vector<Kind>& operands) {
    return kind == gives ? std::optional(operation(op, operands, depth)) : std::nullopt;
  };
  const std::vector<Kind> places = {Kind::Latitude, Kind::Longitude, Kind::Latitude,
                                    Kind::Longitude};
  const std::vector<Kind> course = {Kind::Latitude, Kind::Longitude, Kind::Angle, Kind::Length};
  switch (ir::opIn<ir::FunctionOp>(op)) {
    case ir::FunctionOp::Sin:
    case ir::FunctionOp::Cos:
    case ir::FunctionOp::Tan:
      return when(Kind::Number, {Kind::Angle});
    case ir::FunctionOp::Atan2:
      return when(Kind::Angle, {Kind::Length, Kind::Length});
    case ir::FunctionOp::Distance:
      return when(Kind::Length, places);
    case ir::FunctionOp::Bearing:
      return when(Kind::Angle, places);
    case ir::FunctionOp::Remainder:
      return when(Kind::Length, {Kind::Length, Kind::Length});
    case ir::FunctionOp::Salinity:
    case ir::FunctionOp::Density:
      return std::nullopt;  // no constant or variable of the mission has the types of a CTD
    case ir::FunctionOp::OffsetLatitude:
      return when(Kind::Latitude, course);
    case ir::FunctionOp::OffsetLongitude:
      return when(Kind::Longitude, course);
  }
  return std::nullopt;
}

std::optional<std::string> HardExpressions::numbers(Op op, Kind kind, uint32_t depth) {
  if (kind == Kind::Truth) {
    return std::nullopt;
  }
  const bool place = isPlace(kind);
  switch (ir::opIn<ir::BinaryOp>(op)) {
    case ir::BinaryOp::Min:
    case ir::BinaryOp::Max:
      return operation(op, {kind, kind}, depth);
    case ir::BinaryOp::Add:
    case ir::BinaryOp::Subtract:
      return place ? std::nullopt : std::optional(operation(op, {kind, kind}, depth));
    case ir::BinaryOp::Multiply:
      return place                 ? std::nullopt
             : random_.chance(0.5) ? std::optional(operation(op, {Kind::Number, kind}, depth))
                                   : operation(op, {kind, Kind::Number}, depth);
    case ir::BinaryOp::Divide: {
      const Kind of = random_.chance(0.2) ? Kind::Latitude : measured();
      return place                  ? std::nullopt
             : kind == Kind::Number ? std::optional(operation(op, {of, of}, depth))
                                    : operation(op, {kind, Kind::Number}, depth);
    }
  }
  return std::nullopt;
}

std::optional<std::string> HardExpressions::unary(Op op, Kind kind, uint32_t depth) {
  switch (ir::opIn<ir::UnaryOp>(op)) {
    case ir::UnaryOp::Negate:
    case ir::UnaryOp::Abs:
      return kind == Kind::Truth || isPlace(kind) ? std::nullopt
                                                  : std::optional(operation(op, {kind}, depth));
    case ir::UnaryOp::Sqrt:
      return kind == Kind::Number ? std::optional(operation(op, {kind}, depth)) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<std::string> HardExpressions::called(Kind kind) {
  if (kind == Kind::Length) {
    return "(call 0)";
  }
  if (kind != Kind::Number) {
    return std::nullopt;
  }
  const std::string number = of(Kind::Number, 0);
  return "(call 1 " + number + " " + of(Kind::Length, 0) + " true)";
}

/// Every group of operations has its way here: a new one does not compile without.
std::optional<std::string> HardExpressions::made(Op op, Kind kind, uint32_t depth) {
  const bool truth = kind == Kind::Truth;
  const auto when = [&](bool fits, const std::vector<Kind>& operands) {
    return fits ? std::optional(operation(op, operands, depth)) : std::nullopt;
  };
  const Kind any = random_.chance(0.1) ? Kind::Latitude : measured();
  const auto word = [&](bool fits) {
    return fits ? std::optional(std::string(ir::opInfo(op).text)) : std::nullopt;
  };
  switch (ir::groupOf(op)) {
    case ir::OpGroup::Constant:
      return truth ? std::nullopt : std::optional(constant(kind));
    case ir::OpGroup::Truth:
      return word(truth);
    case ir::OpGroup::Sensor:
      return leaf(op, kind);
    case ir::OpGroup::Age:
      return kind == Kind::Time ? leaf(op, kind) : std::nullopt;
    case ir::OpGroup::Clock:
      return word(kind == Kind::Time && (state_ || op == Op::MissionTime));
    case ir::OpGroup::Variable:
      return named(kind, "(var");
    case ir::OpGroup::Temporal:
      return named(kind, "(temporal");
    case ir::OpGroup::Unary:
      return unary(op, kind, depth);
    case ir::OpGroup::Binary:
      return numbers(op, kind, depth);
    case ir::OpGroup::Function:
      return function(op, kind, depth);
    case ir::OpGroup::Clamp:
      return when(!truth, {kind, kind, kind});
    case ir::OpGroup::Select:
      return when(!truth, {Kind::Truth, kind, kind});
    case ir::OpGroup::Element:
      return isPlace(kind)
                 ? std::optional(fmt::format("(element {} {})", kind == Kind::Latitude ? 0 : 1,
                                             of(Kind::Number, 0)))
                 : std::nullopt;
    case ir::OpGroup::Call:
      return called(kind);
    case ir::OpGroup::Comparison:
      return when(truth, {any, any});
    case ir::OpGroup::Known:
      return when(truth, {any});
    case ir::OpGroup::Logic:
      return when(truth, std::vector<Kind>(ir::opInfo(op).operands, kind));
  }
  return std::nullopt;
}

std::string HardExpressions::duration() {
  const double kind = random_.unit();
  return kind < 0.5 ? constant(Kind::Time) : kind < 0.8 ? plain(Kind::Time) : of(Kind::Time, 1);
}

std::string HardExpressions::guard() {
  constexpr const char* kClocks[] = {"statetime", "statetime", "resumetime", "missiontime"};
  constexpr const char* kWords[] = {"ge", "ge", "ge", "gt", "le", "lt"};
  const double kind = random_.unit();
  if (kind < 0.6) {
    const std::string clock = state_ ? random_.pick(kClocks) : "missiontime";
    const std::string text =
        fmt::format("({} {} {})", random_.pick(kWords), clock,
                    random_.chance(0.6) ? constant(Kind::Time) : plain(Kind::Time));
    return random_.chance(0.1) ? fmt::format("(or {} {})", of(Kind::Truth, 1), text) : text;
  }
  if (kind < 0.8) {
    return named(Kind::Truth, "(temporal").value_or(of(Kind::Truth, 1));
  }
  return of(Kind::Truth, random_.between(1, 3));
}

}  // namespace glider::containment
