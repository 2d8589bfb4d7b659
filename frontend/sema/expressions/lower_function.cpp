// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/decimal_commas.h"
#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_arguments.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/expressions/named_arguments.h"
#include "frontend/sema/names/functions.h"
#include "frontend/spelling.h"
#include "ir/core/ops.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace glider::frontend {

namespace {

/// `depth_of_max` as `depth_of_highest`: with the words of this language.
std::string withOurWords(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"maximum", "highest"}, {"max", "highest"}, {"minimum", "lowest"}, {"min", "lowest"}};
  for (const auto& [theirs, ours] : kWords) {
    if (name.ends_with(fmt::format("_{}", theirs))) {
      return std::string(name.substr(0, name.size() - theirs.size())).append(ours);
    }
  }
  return std::string(name);
}

/// The function that other languages call so.
std::string_view calledElsewhere(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> kNames[] = {
      {"average", "mean"},   {"avg", "mean"},      {"len", "count"},      {"length", "count"},
      {"size", "count"},     {"dist", "distance"}, {"gradient", "slope"}, {"derivative", "rate"},
      {"range", "spread"},   {"mod", "remainder"}, {"fabs", "abs"},       {"maximum", "highest"},
      {"minimum", "lowest"}, {"course", "bearing"}};
  const auto* found =
      std::ranges::find(kNames, name, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kNames) ? std::string_view() : found->second;
}

/// `track(1)` of a path or an array: true, and reported. No fix: other languages count from 1.
bool refuseElement(const ast::Invocation& node, Scope& scope) {
  const ast::NameUse use{node.function.text};
  const bool several =
      isPath({use, node.function.where}, scope) || findArray(node.function.text, scope).has_value();
  if (!several || node.arguments.size() != 1 || node.arguments.front().parameter) {
    return false;
  }
  const std::string better = fmt::format("{}[{}]", node.function.text,
                                         scope.wholeText(node.arguments.front().value->where));
  scope.report(support::diagnostics::unknownFunction, node.function.where, node.function.text,
               fmt::format("write `{}`; elements are counted from 0", better));
  return true;
}

Suggestion suggestFunction(std::string_view wrong, const Scope& scope) {
  constexpr std::pair<std::string_view, std::string_view> kOperators[] = {
      {"and", "write `a && b`: both are true"},
      {"or", "write `a || b`: one is true, or both"},
      {"not", "write `!a`, or `!(a && b)`"},
      {"isnan", "write `!known(…)`"},
      {"xor", "write `(a || b) && !(a && b)`"}};
  for (const auto& [word, hint] : kOperators) {
    if (std::ranges::equal(word, wrong, {}, {}, [](unsigned char c) { return std::tolower(c); })) {
      return {std::string(hint), ""};
    }
  }
  std::vector<std::string_view> names;
  for (const auto& [name, function] : scope.functions) {
    names.push_back(name);
  }
  names.insert(names.end(), functionNames().begin(), functionNames().end());
  const std::string ours = withOurWords(wrong);
  if (ours != wrong && std::ranges::find(names, ours) != names.end()) {
    return {fmt::format("did you mean `{}`?", ours), ""};
  }
  if (const std::string_view known = calledElsewhere(wrong); !known.empty()) {
    return {fmt::format("did you mean `{}`?", known), ""};
  }
  return didYouMean(wrong, names, fmt::format("functions: {}", fmt::join(names, " ")));
}

std::string countedArguments(size_t n) {
  return n == 1 ? "1 argument" : fmt::format("{} arguments", n);
}

}  // namespace

ExprLowering::Result ExprLowering::visit(const ast::Invocation& node, const ast::Expr& expr,
                                         std::optional<ir::Type> want) {
  const std::string& name = node.function.text;
  if (name == ast::kPeersWithin) {
    return peersWithin(node, expr);
  }
  if (isFunctionName(name) && !scope_.functions.contains(name) && refuseNames(node, scope_)) {
    return std::nullopt;
  }
  if (Named* refused = onlyRefusedArray(node)) {
    (void)readable(*refused, expr.where);
    return std::nullopt;
  }
  if (const auto array = onlyArray(node); array && isReservedFunction(name) && name != "count") {
    return ofArray(*array, node, expr);
  }
  if (findWindow(name) && (isReservedFunction(name) || !scope_.declares(name, expr.where))) {
    return window(node, expr);
  }
  if (name == "became" || name == "held") {
    const bool held = name == "held";
    return stretched(node)
               ? std::nullopt
               : overTime(held ? ir::TemporalKind::Held : ir::TemporalKind::Became, node, expr);
  }
  if (isEarthFunction(name)) {
    return stretched(node) ? std::nullopt : onEarth(node, expr);
  }
  if (isPlaceFunction(name) && !scope_.declares(name, expr.where)) {
    return stretched(node) ? std::nullopt : placeOf(node, expr);
  }
  if (isHeadingFunction(name) && !scope_.declares(name, expr.where)) {
    return stretched(node) ? std::nullopt : magnetic(node, expr);
  }
  const Function* function =
      isReservedFunction(name) || !scope_.declares(name, expr.where) ? findFunction(name) : nullptr;
  if (function == nullptr) {
    return inC(node, expr);
  }
  if (stretched(node)) {
    return std::nullopt;
  }
  const size_t wanted = function->argumentCount();
  const auto fits = [wanted](const std::vector<ast::Argument>& read) {
    return read.size() == wanted;
  };
  if (!fits(node.arguments) && refuseDecimalCommas(node.arguments, scope_, fits)) {
    return std::nullopt;
  }
  if (!fits(node.arguments)) {
    auto report = scope_.report(
        support::diagnostics::wrongArgumentCount, expr.where, name, countedArguments(wanted),
        node.arguments.empty() ? "none" : countedArguments(node.arguments.size()),
        fmt::format("{}({})", name, function->arguments));
    if (node.arguments.size() == 1 && (name == "max" || name == "min")) {
      report.hint(fmt::format("over time it is `{0}({1}, this dive)` or `{0}({1}, 10 min)`",
                              name == "max" ? "highest" : "lowest",
                              scope_.text(node.arguments.front().value->where)));
    }
    return std::nullopt;
  }
  if (function->op == ir::Op::Age) {
    return ageOf(node, expr);
  }
  if (const auto type = ir::operandType(ir::opInfo(function->op).takes)) {
    return callOf(*type, function->op, node, expr);
  }
  const bool alone =
      node.arguments.size() == 1 && ir::groupOf(function->op) != ir::OpGroup::Function;
  return alone ? callOne(function->op, node, expr, want) : callMany(function->op, node, expr, want);
}

/// A function that the user has written in C.
ExprLowering::Result ExprLowering::inC(const ast::Invocation& node, const ast::Expr& expr) {
  const std::string& name = node.function.text;
  const auto found = scope_.functions.find(name);
  if (found == scope_.functions.end()) {
    if (scope_.refused_names.contains(name)) {
      return std::nullopt;
    }
    const bool value = findClock(name) || scope_.findSensor(name) != nullptr ||
                       scope_.findConstant(name) != nullptr || scope_.findNamed(name) != nullptr ||
                       meansValue(name, expr.where, scope_);
    if (refuseElement(node, scope_)) {
      return std::nullopt;
    }
    scope_.reportUnknown(
        support::diagnostics::unknownFunction, node.function.where,
        value ? Suggestion{"`" + name + "` is a value: write it without parentheses", ""}
        : onlyArray(node)
            ? Suggestion{"functions of an array: count highest lowest mean spread", ""}
            : suggestFunction(name, scope_),
        name);
    return std::nullopt;
  }
  const FunctionDeclaration& function = found->second;
  if (!function.usable) {
    return std::nullopt;
  }
  if (!scope_.context.constant.empty()) {
    scope_
        .report(support::diagnostics::notConstant, expr.where, scope_.text(expr.where),
                scope_.context.constant)
        .note(function.name->where, "it is a C function");
    return std::nullopt;
  }
  const auto arguments =
      lowerArguments(node.arguments, {name, function.signature, function.name}, expr.where, scope_);
  if (!arguments) {
    return std::nullopt;
  }
  const ir::UseId call{static_cast<uint32_t>(scope_.mission.uses.size())};
  scope_.mission.uses.push_back({scope_.function(function), expr.where});
  return valueOf(ir::MissionWriter(scope_.mission, expr.where).call(call, arguments->values));
}

bool ExprLowering::stretched(const ast::Invocation& node) {
  for (const ast::Argument& argument : node.arguments) {
    if (argument.of) {
      scope_.report(support::diagnostics::ofOutsideWindow, argument.of->where, node.function.text);
      return true;
    }
  }
  return false;
}

ExprLowering::Result ExprLowering::ageOf(const ast::Invocation& node, const ast::Expr& expr) {
  const ast::Expr& argument = *node.arguments.front().value;
  const auto* use = std::get_if<ast::NameUse>(&argument.node);
  const platforms::PlatformSensor* sensor = use != nullptr ? scope_.findSensor(use->name) : nullptr;
  if (sensor == nullptr) {
    if (use == nullptr || (!scope_.refused_names.contains(use->name) &&
                           !scope_.refuseVehicle(use->name, argument.where))) {
      scope_.report(support::diagnostics::ageOfWhat, argument.where, scope_.text(argument.where));
    }
    return std::nullopt;
  }
  const ir::SensorId id = scope_.subscribe(*sensor, use->name);
  reads_.push_back({sensor, use->name, argument.where});
  return valueOf(ir::MissionWriter(scope_.mission, expr.where).age(id));
}

/// A function whose arguments all have the type that its operation requires.
ExprLowering::Result ExprLowering::callOf(const ir::Type& type, ir::Op op,
                                          const ast::Invocation& node, const ast::Expr& expr) {
  std::vector<ir::ExprId> operands;
  for (const ast::Argument& argument : node.arguments) {
    const auto value =
        lowerAs(*argument.value, type, "the argument of `" + node.function.text + "`");
    operands.push_back(value.value_or(ir::ExprId()));
  }
  const bool good = std::ranges::all_of(operands, &ir::ExprId::valid);
  return good ? Result(emitOf(op, expr.where, operands)) : std::nullopt;
}

/// abs, sqrt and known.
ExprLowering::Result ExprLowering::callOne(ir::Op op, const ast::Invocation& node,
                                           const ast::Expr& expr, std::optional<ir::Type> want) {
  const ast::Expr& argument = *node.arguments.front().value;
  const bool keeps = op == ir::Op::Abs;
  const Result value = lower(argument, keeps ? want : std::nullopt);
  if (op == ir::Op::Known && value && value->longitude.valid()) {
    const ir::ExprId north = emit(op, boolean(), expr.where, {value->id}).id;
    const ir::ExprId east = emit(op, boolean(), expr.where, {value->longitude}).id;
    return emit(ir::Op::And, boolean(), expr.where, {north, east});
  }
  if (!value || !numeric(*value, argument, node.function.text, op == ir::Op::Known)) {
    return std::nullopt;
  }
  if (op == ir::Op::Known) {
    return emit(op, boolean(), expr.where, {value->id});
  }
  if (keeps) {
    Value result = emit(op, value->type, expr.where, {value->id});
    result.scale = value->scale;
    return result;
  }
  const auto root = support::squareRoot(value->type.dimension);
  if (!root) {
    scope_.report(support::diagnostics::noSquareRoot, argument.where, scope_.text(argument.where),
                  describe(value->type));
    return std::nullopt;
  }
  return emit(op, quantity(*root), expr.where, {value->id});
}

/// False, and reported, if `clamp` has its limits turned round, as far as they are known. A value
/// that never changes between limits that do is probably a limit.
bool ExprLowering::inOrder(const std::vector<ir::ExprId>& operands, const ast::Invocation& node,
                           const ast::Expr& expr) {
  std::array<std::optional<double>, 3> known;
  std::array<std::string, 3> texts;
  for (size_t i = 0; i < known.size(); ++i) {
    known.at(i) = evaluate(scope_.mission, operands.at(i));
    texts.at(i) = scope_.text(node.arguments[i].value->where);
  }
  const auto& [value, lowest, highest] = known;
  const size_t changing = !lowest ? 1 : 2;
  if (value && (!lowest != !highest)) {
    scope_.report(
        support::diagnostics::clampValue, expr.where, scope_.text(expr.where),
        fmt::format("clamp({}, {}, {})", texts.at(changing), texts[0], texts.at(3 - changing)));
  }
  if (lowest && highest && *lowest > *highest) {
    scope_.report(support::diagnostics::clampOrder, expr.where, scope_.text(expr.where),
                  fmt::format("clamp({}, {}, {})", texts[0], texts[2], texts[1]));
    return false;
  }
  return true;
}

/// min, max, clamp, atan2 and similar functions: all arguments have one type, and bare numbers take
/// the unit of the others.
ExprLowering::Result ExprLowering::callMany(ir::Op op, const ast::Invocation& node,
                                            const ast::Expr& expr, std::optional<ir::Type> want) {
  const auto leads = [](const ast::Argument& argument) {
    return !takesUnitOfContext(*argument.value);
  };
  const auto leader = std::ranges::find_if(node.arguments, leads);
  const size_t first =
      leader == node.arguments.end() ? 0 : static_cast<size_t>(leader - node.arguments.begin());
  const ast::Expr& model = *node.arguments[first].value;
  const ir::OpInfo& info = ir::opInfo(op);
  const Result led = lower(model, info.gives == ir::Gives::Same ? want : std::nullopt);
  if (!led || !numeric(*led, model, node.function.text, info.takes == ir::Takes::Alike)) {
    return std::nullopt;
  }
  std::vector<ir::ExprId> operands(node.arguments.size());
  Scale scale = led->scale;
  bool good = true;
  for (size_t i = 0; i < node.arguments.size(); ++i) {
    const ast::Expr& argument = *node.arguments[i].value;
    const Result value = i == first ? led : lower(argument, led->type);
    if (!value) {
      good = false;
    } else if (value->longitude.valid() || value->type != led->type) {
      auto report = scope_.report(
          support::diagnostics::typesDiffer, argument.where, scope_.text(model.where),
          describe(led->type), scope_.text(argument.where),
          value->longitude.valid() ? "a position" : describe(value->type), node.function.text);
      const bool window = value->type == quantity(support::dimension::time) && i == 1;
      if (window && (op == ir::Op::Min || op == ir::Op::Max)) {  // meant over time
        report.hint(fmt::format("over time it is `{}({}, {})`",
                                op == ir::Op::Min ? "lowest" : "highest", scope_.text(model.where),
                                scope_.text(argument.where)));
      }
      good = false;
    } else if (scalesDiffer(*led, model.where, *value, argument.where, node.function.text)) {
      good = false;
    } else {
      operands[i] = value->id;
      scale = commonScale(scale, value->scale);
    }
  }
  if (!good) {
    return std::nullopt;
  }
  if (op == ir::Op::Clamp && !inOrder(operands, node, expr)) {
    return std::nullopt;
  }
  Value result = emitOf(op, expr.where, operands);
  result.scale = info.gives == ir::Gives::Same ? scale : Scale{};
  return result;
}

}  // namespace glider::frontend
