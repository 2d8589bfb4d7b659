// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/bare_positions.h"
#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "ir/core/ops.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string>

namespace glider::frontend {

namespace {

struct OperatorRow {
  ir::Op op;
  std::string_view text;
};

/// In the order of ast::BinaryOp.
constexpr OperatorRow kOperators[] = {
    {ir::Op::Multiply, "*"},  {ir::Op::Divide, "/"},        {ir::Op::Add, "+"},
    {ir::Op::Subtract, "-"},  {ir::Op::Less, "<"},          {ir::Op::LessEqual, "<="},
    {ir::Op::Greater, ">"},   {ir::Op::GreaterEqual, ">="}, {ir::Op::Equal, "=="},
    {ir::Op::NotEqual, "!="}, {ir::Op::And, "&&"},          {ir::Op::Or, "||"}};

const OperatorRow& rowOf(ast::BinaryOp op) {
  return kOperators[static_cast<size_t>(op)];
}

bool isComparison(ast::BinaryOp op) {
  return op >= ast::BinaryOp::Less && op <= ast::BinaryOp::NotEqual;
}

/// Whether both mean that values rise, or both that they fall: `5 m < depth <= 10 m`.
bool sameWay(ast::BinaryOp a, ast::BinaryOp b) {
  const auto rises = [](ast::BinaryOp op) {
    return op == ast::BinaryOp::Less || op == ast::BinaryOp::LessEqual;
  };
  const auto falls = [](ast::BinaryOp op) {
    return op == ast::BinaryOp::Greater || op == ast::BinaryOp::GreaterEqual;
  };
  return (rises(a) && rises(b)) || (falls(a) && falls(b));
}

/// Whether a sensor of the vehicle gives whole numbers, which can be compared exactly.
bool counts(const std::string& vehicle_name, const Scope& scope) {
  const auto& sensors = scope.platform().sensors;
  const auto found = std::ranges::find(sensors, vehicle_name, &platforms::PlatformSensor::name);
  return found != sensors.end() && found->counts;
}

/// Whether a reading, other than a count, or a clock is in the expression.
bool measured(const Scope& scope, ir::ExprId id) {
  const ir::Expr& expr = scope.mission[id];
  if (expr.type == boolean()) {
    return false;  // what is chosen or counted by it is exact
  }
  const bool reading =
      expr.op == ir::Op::Sensor && !counts(scope.mission[expr.sensor].vehicle_name, scope);
  const bool itself =
      reading || expr.op == ir::Op::Age || ir::groupOf(expr.op) == ir::OpGroup::Clock;
  return itself || std::ranges::any_of(expr.operands, [&](ir::ExprId operand) {
           return operand.valid() && measured(scope, operand);
         });
}

}  // namespace

ExprLowering::Result ExprLowering::visit(const ast::Binary& node, const ast::Expr& expr,
                                         std::optional<ir::Type> want) {
  const ir::Op op = rowOf(node.op).op;
  switch (node.op) {
    case ast::BinaryOp::And:
    case ast::BinaryOp::Or:
      return condition(op, node, expr);
    case ast::BinaryOp::Add:
    case ast::BinaryOp::Subtract:
      return sum(op, node, expr, want);
    case ast::BinaryOp::Multiply:
    case ast::BinaryOp::Divide:
      return scaling(op, node, expr);
    case ast::BinaryOp::Less:
    case ast::BinaryOp::LessEqual:
    case ast::BinaryOp::Greater:
    case ast::BinaryOp::GreaterEqual:
    case ast::BinaryOp::Equal:
    case ast::BinaryOp::NotEqual:
      break;
  }
  return comparison(op, node, expr);
}

ExprLowering::Result ExprLowering::visit(const ast::Unary& node, const ast::Expr& expr,
                                         std::optional<ir::Type> want) {
  if (node.op == ast::UnaryOp::Not) {
    const auto operand = lowerCondition(*node.operand);
    return operand ? Result(emit(ir::Op::Not, boolean(), expr.where, {*operand})) : std::nullopt;
  }
  if (const auto* literal = std::get_if<ast::Literal>(&node.operand->node)) {
    if (literal->unit.empty()) {
      return bareLiteral(*literal, expr.where, want, true);
    }
    if (isMagneticUnit(literal->unit)) {
      return refuseMagnetic(*literal, expr.where);
    }
  }
  const Result operand = lower(*node.operand, want);
  if (!operand) {
    return std::nullopt;
  }
  const auto* literal = std::get_if<ast::Literal>(&node.operand->node);
  const bool earth =
      operand->type.kind == ir::TypeKind::Latitude || operand->type.kind == ir::TypeKind::Longitude;
  if (literal != nullptr && earth) {
    // No fix: `-73.8 W` is 73.8 W to most pilots, and 73.8 E to arithmetic.
    constexpr std::string_view kLetters = "NSEW";
    constexpr std::string_view kOpposite = "SNWE";
    scope_.report(support::diagnostics::signAndLetter, expr.where, scope_.text(expr.where),
                  literal->digits, literal->unit, kOpposite[kLetters.find(literal->unit)]);
    return std::nullopt;
  }
  if (!numeric(*operand, *node.operand, "-", false)) {
    return std::nullopt;
  }
  Value negative = emit(ir::Op::Negate, operand->type, expr.where, {operand->id});
  negative.scale = operand->scale;
  return negative;
}

bool ExprLowering::numeric(const Value& value, const ast::Expr& expr, std::string_view op,
                           bool earth) {
  if (value.longitude.valid() ||
      (!earth && value.type.kind != ir::TypeKind::Quantity && value.type != boolean())) {
    const bool whole = value.longitude.valid();
    auto report =
        scope_.report(support::diagnostics::positionArithmetic, expr.where, scope_.text(expr.where),
                      whole ? "a position" : describe(value.type), op);
    if (whole) {
      report.hint(
          "write how far away it is, as in `distance(home) < 200 m`, or compare `lat` or `lon`");
    }
    return false;
  }
  if (value.type == boolean()) {
    scope_.report(support::diagnostics::conditionAsNumber, expr.where, scope_.text(expr.where), op);
    return false;
  }
  return true;
}

ExprLowering::Result ExprLowering::condition(ir::Op op, const ast::Binary& node,
                                             const ast::Expr& expr) {
  const auto left = lowerCondition(*node.left);
  const auto right = lowerCondition(*node.right);
  if (!left || !right) {
    return std::nullopt;
  }
  return emit(op, boolean(), expr.where, {*left, *right});
}

namespace {

/// `oxygen < 80 %`: a share where the other side, which is not a share of anything written, counts
/// something.
void markPercentage(const ast::Expr& other, const ast::Expr& share, Value& value,
                    const Scale& counted) {
  const auto* literal = std::get_if<ast::Literal>(&share.node);
  const bool counts = !counted.unit.empty() && counted.unit != "%";
  if (literal != nullptr && literal->unit == "%" && counts &&
      !std::holds_alternative<ast::Binary>(other.node)) {
    value.scale = {"%", true};
  }
}

}  // namespace

std::optional<ExprLowering::Pair> ExprLowering::alike(const ast::Expr& left, const ast::Expr& right,
                                                      std::optional<ir::Type> want,
                                                      std::string_view op) {
  // The side that has a unit of its own is lowered first; bare numbers of the other side take that
  // unit.
  const bool rightFirst = takesUnitOfContext(left) && !takesUnitOfContext(right);
  const ast::Expr& first = rightFirst ? right : left;
  const ast::Expr& second = rightFirst ? left : right;
  const bool bothBare = takesUnitOfContext(left) && takesUnitOfContext(right);
  const Result one = lower(first, bothBare || takesUnitOfContext(first) ? want : std::nullopt);
  if (!one && takesUnitOfContext(second)) {
    return std::nullopt;  // a bare number beside an error: nothing to report
  }
  const Result two = lower(second, one ? std::optional(one->type) : want);
  if (!one || !two) {
    return std::nullopt;
  }
  if (one->longitude.valid() != two->longitude.valid() || one->type != two->type) {
    const Value& l = rightFirst ? *two : *one;
    const Value& r = rightFirst ? *one : *two;
    const bool plain_left = l.type == plainNumber();
    const MissingUnit constant = plain_left ? missingUnitOf(left, DeclaredType{r.type})
                                            : missingUnitOf(right, DeclaredType{l.type});
    if (constant.reported) {
      return std::nullopt;
    }
    auto say = [](const Value& v) {
      return v.longitude.valid() ? std::string("a position") : describe(v.type);
    };
    auto report =
        scope_.report(support::diagnostics::typesDiffer,
                      support::SourceRange{left.where.file, left.where.begin, right.where.end},
                      scope_.text(left.where), say(l), scope_.text(right.where), say(r), op);
    suggestUnit(right, l.type, op, report);
    constant.explain(report);
    if (l.charge.valid() || r.charge.valid()) {
      report.hint(
          fmt::format("`energyleft` is a share, as in `energyleft {} 30 %`; an amount is "
                      "compared with `energyused`",
                      op));
    }
    return std::nullopt;
  }
  Pair pair = rightFirst ? Pair{*two, *one} : Pair{*one, *two};
  markPercentage(left, right, pair.right, pair.left.scale);
  markPercentage(right, left, pair.left, pair.right.scale);
  return scalesDiffer(pair.left, left.where, pair.right, right.where, op) ? std::nullopt
                                                                          : std::optional(pair);
}

void ExprLowering::suggestUnit(const ast::Expr& value, const ir::Type& other, std::string_view op,
                               support::DiagnosticBuilder& report) {
  const auto* literal = std::get_if<ast::Literal>(&value.node);
  const bool compares = op.find_first_of("<>=") != std::string_view::npos;
  if (compares && other.kind == ir::TypeKind::Bool) {
    report.hint("a condition is true or false by itself: write it alone, or with `!` before it");
    return;
  }
  if (literal == nullptr || !compares || !support::parseUnit(literal->unit) ||
      literal->unit.empty() || other.kind != ir::TypeKind::Quantity) {
    return;
  }
  if (literal->unit == "m" && other.dimension == support::dimension::time) {
    report.hint(fmt::format("write `{} min`: `m` is metres", literal->digits))
        .fix(literal->unit_where, "min");
    return;
  }
  const bool percent = literal->unit == "%";
  if (percent && (other.dimension == support::dimension::voltage ||
                  other.dimension == support::dimension::charge)) {
    const bool voltage = other.dimension == support::dimension::voltage;
    report.hint(fmt::format(
        "what is left of the batteries is `energyleft {} {} %`, with a line `pack`; "
        "{}",
        op, literal->digits,
        voltage ? "`battery` is their voltage, in V" : "`charge` is what was used, in Ah"));
    return;
  }
  if (percent && other.dimension == support::dimension::energy) {
    report.hint(
        "a share is `energyleft`, which falls from 100 %; `energyused` is an amount, such as "
        "`40 Wh`");
    return;
  }
  const std::string unit = pilotsUnit(other.dimension);
  if (!unit.empty()) {
    report.hint(fmt::format("both sides of `{}` must have the same kind of value, such as `{} {}`",
                            op, literal->digits, unit));
  }
}

bool ExprLowering::sideBySide(const ast::Binary& node, const ast::Expr& expr) {
  const auto* unary = std::get_if<ast::Unary>(&node.left->node);
  const bool negative = unary != nullptr && unary->op == ast::UnaryOp::Negate;
  const auto* first =
      std::get_if<ast::Literal>(negative ? &unary->operand->node : &node.left->node);
  const auto* second = std::get_if<ast::Literal>(&node.right->node);
  if (node.op != ast::BinaryOp::Subtract || first == nullptr || second == nullptr ||
      !first->unit.empty() || !second->unit.empty()) {
    return false;
  }
  // `(3910.6) - 7349.9` certainly means a difference.
  const std::string gap = scope_.text({expr.where.file, node.left->where.end, node.op_where.begin});
  if (gap.find(')') != std::string::npos) {
    return false;
  }
  const bool before = node.op_where.begin > node.left->where.end;
  const bool after = node.right->where.begin > node.op_where.end;
  const auto better = pairWithLetters({first->digits, negative}, {second->digits, true});
  if (!better || !isPairByLooks(first->digits, second->digits, before, after)) {
    return false;
  }
  auto report =
      scope_.report(support::diagnostics::barePosition, expr.where, scope_.text(expr.where),
                    fmt::format("`{}`; if a difference is meant, `({}) - {}`", *better,
                                scope_.text(node.left->where), second->digits));
  if (scope_.context.constant == "a path" && before && !after) {
    report.fix(expr.where, *better);  // an element of a path is never a difference
  }
  return true;
}

ExprLowering::Result ExprLowering::sum(ir::Op op, const ast::Binary& node, const ast::Expr& expr,
                                       std::optional<ir::Type> want) {
  const std::string_view text = rowOf(node.op).text;
  if (isDate(node, expr) || sideBySide(node, expr)) {
    return std::nullopt;
  }
  const auto pair = alike(*node.left, *node.right, want, text);
  if (!pair || !numeric(pair->left, *node.left, text, false)) {
    return std::nullopt;
  }
  Value result = emit(op, pair->left.type, expr.where, {pair->left.id, pair->right.id});
  result.scale = commonScale(pair->left.scale, pair->right.scale);
  return result;
}

ExprLowering::Result ExprLowering::scaling(ir::Op op, const ast::Binary& node,
                                           const ast::Expr& expr) {
  const std::string_view text = rowOf(node.op).text;
  if (isDate(node, expr)) {
    return std::nullopt;
  }
  const Result left = lower(*node.left, std::nullopt);
  const Result right = lower(*node.right, std::nullopt);
  if (!left || !right || !numeric(*left, *node.left, text, false) ||
      !numeric(*right, *node.right, text, false)) {
    return std::nullopt;
  }
  const bool divides = op == ir::Op::Divide;
  const auto dimension = divides ? support::quotient(left->type.dimension, right->type.dimension)
                                 : support::product(left->type.dimension, right->type.dimension);
  if (!dimension) {
    scope_.report(support::diagnostics::noSuchQuantity, expr.where, scope_.text(expr.where));
    return std::nullopt;
  }
  if (divides && evaluate(scope_.mission, right->id) == 0.0) {
    scope_.report(support::diagnostics::divisionByZero, node.right->where,
                  scope_.text(node.right->where));
    return std::nullopt;
  }
  return emit(op, quantity(*dimension), expr.where, {left->id, right->id});
}

namespace {

/// An operand as it is written, but a number with the unit that its word means: `12 C` is 12 degC.
std::string meantText(const ast::Expr& expr, const Scope& scope) {
  const auto* literal = std::get_if<ast::Literal>(&expr.node);
  return literal == nullptr || literal->unit.empty() ||
                 scope.text(literal->unit_where) == literal->unit
             ? scope.text(expr.where)
             : fmt::format("{} {}", literal->digits, literal->unit);
}

/// " h" for the first number of `2 < statetime < 4 h`: it is meant in the unit of the other.
std::string missingUnit(const ast::Expr& number, const ast::Expr& other) {
  const auto* bare = std::get_if<ast::Literal>(&number.node);
  const auto* with = std::get_if<ast::Literal>(&other.node);
  return bare != nullptr && with != nullptr && bare->unit.empty() && !with->unit.empty()
             ? " " + with->unit
             : "";
}

/// The value of a number with a unit; empty: it is something else.
std::optional<double> writtenValue(const ast::Expr& expr) {
  const auto* literal = std::get_if<ast::Literal>(&expr.node);
  const auto unit = literal == nullptr ? std::nullopt : support::parseUnit(literal->unit);
  return unit ? std::optional(std::strtod(literal->digits.c_str(), nullptr) * unit->to_si)
              : std::nullopt;
}

/// `>` for `<`.
std::string_view mirrored(ast::BinaryOp op) {
  return std::ranges::find(kOperators, ir::mirrored(rowOf(op).op), &OperatorRow::op)->text;
}

/// Whether no value is between the two numbers of `23 h < timeofday < 11 h`.
bool isNeverBetween(const ast::Binary& first, const ast::Binary& second) {
  const auto one = writtenValue(*first.left);
  const auto other = writtenValue(*second.right);
  if (!one || !other || !sameWay(first.op, second.op)) {
    return false;
  }
  const bool rises = first.op == ast::BinaryOp::Less || first.op == ast::BinaryOp::LessEqual;
  return rises ? *one > *other : *one < *other;
}

/// What is meant by `23 h < timeofday < 11 h`: of another value than the time of the day, the
/// numbers may have been exchanged.
std::string outsideOf(const ast::Binary& first, const ast::Binary& second, const Scope& scope) {
  const std::string value = scope.text(first.right->where);
  const std::string one = scope.text(first.left->where);
  const std::string other = scope.text(second.right->where);
  std::string hint = fmt::format("write `{} {} {} || {} {} {}`", value, mirrored(first.op), one,
                                 value, rowOf(second.op).text, other);
  if (value != "timeofday") {
    hint += fmt::format(", or `{} {} {} && {} {} {}`", other, rowOf(first.op).text, value, value,
                        rowOf(second.op).text, one);
  }
  return hint;
}

}  // namespace

bool ExprLowering::chained(const ast::Binary& node, const ast::Expr& expr) {
  const auto* unary = std::get_if<ast::Unary>(&node.left->node);
  if (unary != nullptr && unary->op == ast::UnaryOp::Not) {
    const std::string first = scope_.text(unary->operand->where);
    const std::string second = meantText(*node.right, scope_);
    scope_
        .report(support::diagnostics::notBeforeComparison, expr.where, first, rowOf(node.op).text,
                second)
        .fix(expr.where, fmt::format("!({} {} {})", first, rowOf(node.op).text, second));
    return true;
  }
  const auto* inner = std::get_if<ast::Binary>(&node.left->node);
  if (inner == nullptr || !isComparison(inner->op)) {
    return false;
  }
  const std::string first = fmt::format("{}{} {} {}", scope_.text(inner->left->where),
                                        missingUnit(*inner->left, *node.right),
                                        rowOf(inner->op).text, scope_.text(inner->right->where));
  const std::string second =
      fmt::format("{} {} {}{}", scope_.text(inner->right->where), rowOf(node.op).text,
                  scope_.text(node.right->where), missingUnit(*node.right, *inner->left));
  auto report = scope_.report(support::diagnostics::chainedComparison, expr.where,
                              scope_.text(expr.where), first, second);
  if (isNeverBetween(*inner, node)) {
    report.hint(outsideOf(*inner, node, scope_));
  } else if (sameWay(inner->op, node.op)) {
    // In parentheses: a `not` before it applies to the whole.
    report.fix(expr.where, "(" + first + " && " + second + ")");
  }
  return true;
}

ExprLowering::Result ExprLowering::comparison(ir::Op op, const ast::Binary& node,
                                              const ast::Expr& expr) {
  if (chained(node, expr)) {
    return std::nullopt;
  }
  const std::string_view text = rowOf(node.op).text;
  const size_t before = scope_.mission.exprs.size();
  auto pair = alike(*node.left, *node.right, std::nullopt, text);
  if (!pair || !numeric(pair->left, *node.left, text, true)) {
    return std::nullopt;
  }
  if (tooSoonAfter1970(pair->left, *node.left, pair->right, *node.right) ||
      tooSoonAfter1970(pair->right, *node.right, pair->left, *node.left)) {
    return std::nullopt;
  }
  warnOfEquality(op, pair->left, pair->right, node);
  warnOfBareHours(*node.left, *node.right);
  warnOfBareHours(*node.right, *node.left);
  compareOnCompass(op, *pair, node);
  if (const Result by_charge = comparedByCharge(op, *pair, before, expr.where)) {
    return by_charge;
  }
  return emit(op, boolean(), expr.where, {pair->left.id, pair->right.id});
}

/// `energyleft < 30 %` as a comparison of the charge with a constant, which rounds nothing: so a
/// requirement about it agrees with the guards about it. Empty if it is not one. It takes the place
/// of what was lowered from expression `before` on.
ExprLowering::Result ExprLowering::comparedByCharge(ir::Op op, const Pair& pair, size_t before,
                                                    const support::SourceRange& range) {
  const bool left = pair.left.charge.valid();
  if (left == pair.right.charge.valid()) {
    return std::nullopt;
  }
  const auto share = evaluate(scope_.mission, (left ? pair.right : pair.left).id);
  if (!share) {
    return std::nullopt;
  }
  if (*share > 1) {
    const support::SourceRange& where = scope_.mission[(left ? pair.right : pair.left).id].range;
    auto report = scope_.report(support::diagnostics::shareAboveOne, where, scope_.text(where));
    constexpr double kPercent = 100;
    if (*share <= kPercent &&
        scope_.text(where).find_first_not_of("0123456789.") == std::string::npos) {
      report.hint(fmt::format("write `{} %`", scope_.text(where)))
          .fix({where.file, where.end, where.end}, " %");
    }
  }
  const ir::SensorId counter = scope_.mission[(left ? pair.left : pair.right).charge].sensor;
  scope_.mission.exprs.resize(before);
  const ir::ExprId charge = ir::MissionWriter(scope_.mission, range).read(counter);
  const double used_C = (1 - *share) * scope_.energy->pack.capacity_C;
  const ir::ExprId limit = emitNumber(used_C, quantity(support::dimension::charge), range).id;
  return emit(left ? ir::mirrored(op) : op, boolean(), range, {charge, limit});
}

/// `timeofday >= 1315` is meant as 13 h 15 min, and means 1315 s.
void ExprLowering::warnOfBareHours(const ast::Expr& clock, const ast::Expr& time) {
  const auto* name = std::get_if<ast::NameUse>(&clock.node);
  const auto* bare = std::get_if<ast::Literal>(&time.node);
  if (name == nullptr || name->name != "timeofday" || scope_.declares(name->name, clock.where) ||
      bare == nullptr || !bare->unit.empty() ||
      bare->digits.find_first_not_of("0123456789") != std::string::npos) {
    return;
  }
  constexpr int kHours = 24, kMinutes = 60, kHundred = 100, kHour_s = 3600, kMinute_s = 60;
  const int seconds = bare->digits.size() <= 5 ? std::stoi(bare->digits) : 0;
  if (seconds == 0) {
    return;
  }
  const int hours = seconds / kHundred, minutes = seconds % kHundred;
  const bool clocked = bare->digits.size() == 4 && hours <= kHours && minutes < kMinutes;
  auto report = scope_.report(support::diagnostics::bareTimeOfDay, time.where, bare->digits,
                              fmt::format("{:02}:{:02}:{:02}", seconds / kHour_s,
                                          seconds / kMinute_s % kMinutes, seconds % kMinute_s));
  if (seconds <= kHours || clocked) {
    const std::string meant = seconds <= kHours ? fmt::format("{} h", seconds)
                              : minutes == 0    ? fmt::format("{} h", hours)
                                                : fmt::format("{} h {} min", hours, minutes);
    report.hint(fmt::format("write `{}`, or `{} s` if that is meant", meant, seconds));
  }
}

void ExprLowering::warnOfEquality(ir::Op op, const Value& left, const Value& right,
                                  const ast::Binary& node) {
  const bool equality = op == ir::Op::Equal || op == ir::Op::NotEqual;
  // `=` has been reported: which comparison is meant is not known.
  const bool written = scope_.text(node.op_where) != "=";
  if (!equality || !written || !(measured(scope_, left.id) || measured(scope_, right.id))) {
    return;
  }
  scope_.report(support::diagnostics::measuredEquality, node.op_where,
                op == ir::Op::Equal ? "==" : "!=", op == ir::Op::Equal ? "true" : "false");
}

}  // namespace glider::frontend
