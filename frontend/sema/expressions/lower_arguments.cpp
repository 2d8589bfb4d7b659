// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_arguments.h"

#include "frontend/bare_positions.h"
#include "frontend/sema/expressions/decimal_commas.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/expressions/named_arguments.h"
#include "ir/core/walk.h"
#include "ir/verify/intervals.h"
#include "ir/verify/value_text.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace glider::frontend {

namespace {

std::string countOf(size_t n) {
  return n == 0 ? "no arguments" : n == 1 ? "1 argument" : fmt::format("{} arguments", n);
}

/// Whether it is a number with a unit of that dimension.
bool isLiteralOf(const ast::Argument& argument, const support::Dimension& dimension) {
  const auto* literal = std::get_if<ast::Literal>(&argument.value->node);
  const auto unit = literal != nullptr ? support::parseUnit(literal->unit) : std::nullopt;
  return unit && unit->dimension == dimension;
}

class ArgumentLowering {
 public:
  ArgumentLowering(const std::vector<ast::Argument>& arguments, const Callee& callee,
                   const support::SourceRange& where, Scope& scope)
      : arguments_(arguments), callee_(callee), where_(where), scope_(scope) {}

  std::optional<Arguments> run() {
    if (!plan()) {
      const auto fits = [this](const std::vector<ast::Argument>& read) {
        return ArgumentLowering(read, callee_, where_, scope_).plan();
      };
      if (!refusePath() && !refuseDecimalCommas(arguments_, scope_, fits)) {
        wrongCount();
      }
      return std::nullopt;
    }
    bool good = true;
    for (const Step& step : steps_) {
      good = lower(step) && good;
    }
    return good ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  /// Which arguments correspond to which formals.
  struct Step {
    size_t formal;
    size_t formals;  ///< 2: a position for a latitude and a longitude
    size_t argument;
    size_t arguments;  ///< 2: a latitude and a longitude for a position; 0: the usual one
  };

  [[nodiscard]] const std::vector<Signature::Formal>& formals() const {
    return callee_.signature.formals;
  }

  [[nodiscard]] bool latitudeAndLongitude(size_t formal) const {
    return isLatitudeAndLongitude(callee_.signature, formal);
  }

  /// False if there are too few or too many arguments.
  bool plan() {
    size_t formal = 0;
    size_t argument = 0;
    while (formal < formals().size() && argument < arguments_.size()) {
      const bool position = isPosition(*arguments_[argument].value, scope_);
      const size_t left = arguments_.size() - argument;
      const bool halves =
          formals()[formal].type.position && !position && left > formals().size() - formal;
      const bool pair = position && latitudeAndLongitude(formal);
      steps_.push_back({formal, pair ? 2U : 1U, argument, halves ? 2U : 1U});
      formal += steps_.back().formals;
      argument += steps_.back().arguments;
    }
    filled_ = formal + (arguments_.size() - std::min(argument, arguments_.size()));
    while (formal < formals().size() && formals()[formal].usual != nullptr) {
      steps_.push_back({formal++, 1, argument, 0});
    }
    return formal == formals().size() && argument == arguments_.size();
  }

  /// Whether named arguments were completed by it: it stands where the parameter does.
  static bool isUsual(const Signature::Formal& formal, const ast::Argument& argument) {
    const support::SourceRange& given = argument.value->where;
    return formal.usual != nullptr && given.valid() &&
           given == static_cast<const support::SourceRange&>(formal.usual->where);
  }

  /// "`depth` of `climb_to`". By hand: it is made of every argument, though few have an error.
  [[nodiscard]] std::string nameOf(const Signature::Formal& formal) const {
    std::string name = "`";
    name.append(formal.name->text).append("` of `").append(callee_.name).append("`");
    return name;
  }

  bool lower(const Step& step) {
    const Signature::Formal& formal = formals()[step.formal];
    const std::string what = nameOf(formal);
    const bool usual = step.arguments == 0 || isUsual(formal, arguments_[step.argument]);
    if (usual) {
      return addUsual(formal, what);
    }
    if (step.formals == 2) {
      return add(step.argument, {latitude(), true}, what) && positionInRange(step);
    }
    const bool whole = step.arguments == 2 || latitudeAndLongitude(step.formal);
    if (whole && (longitudeFirst(step.argument) || decimalDegrees(step.argument))) {
      return false;
    }
    if (reported_ == step.argument || exchanged(step)) {
      return false;
    }
    if (step.arguments == 2) {
      const bool first = add(step.argument, {latitude(), false}, "the latitude of " + what);
      const bool same_error =
          !first && ExprLowering::areBareHalves(*arguments_[step.argument].value,
                                                *arguments_[step.argument + 1].value, true);
      return !same_error &&
             add(step.argument + 1, {longitude(), false}, "the longitude of " + what) && first;
    }
    if (formal.type.position && lacksComma(arguments_[step.argument])) {
      const ast::Argument& pair = arguments_[step.argument];
      reportMissingComma(pair, "a latitude and a longitude")
          .fix(differenceIn(pair)->op_where, ", -");
      return false;
    }
    return add(step.argument, formal.type, what) &&
           (formal.range == nullptr || isInRange(formal, arguments_[step.argument], what));
  }

  /// Of the value that was added last, if it follows from constants and parameters of the mission:
  /// what changes in flight is taken. What has no bounds, as a parameter without a range, is
  /// refused only where no value of it would do.
  bool isInRange(const Signature::Formal& formal, const ast::Argument& argument,
                 const std::string& what) {
    constexpr double kNoBound = 1e300;
    const ir::ExprId value = result_.values.back();
    const bool bare_angle = formal.type.type == quantity(support::dimension::angle) &&
                            takesUnitOfContext(*argument.value);  // reported if it is a large one
    if (bare_angle || !isKnownAtStart(value)) {
      return true;
    }
    const ir::Interval values =
        ir::SubtreeIntervals(scope_.mission).of(value, [](uint32_t, const ir::Interval& interval) {
          return interval;
        });
    const bool constant = values.lowest == values.highest;
    const bool never = values.lowest > formal.highest || values.highest < formal.lowest;
    const bool above = values.highest > formal.highest;
    const double end =
        never ? (above ? values.lowest : values.highest) : (above ? values.highest : values.lowest);
    if (values.within(formal.lowest, formal.highest) ||
        (!never && !constant && std::fabs(end) > kNoBound)) {
      return true;
    }
    const bool written = constant && isNumber(*argument.value);
    auto report = scope_.report(
        support::diagnostics::argumentOutside, argument.value->where, what,
        constant ? "is" : "may be",
        written ? scope_.text(argument.value->where) : ir::withUnit(end, formal.type.type),
        scope_.text(formal.range->lowest.where), scope_.text(formal.range->highest.where));
    if (const std::string units = written ? withMissingUnit(formal, argument) : "";
        !units.empty()) {
      report.hint(fmt::format("a number alone is in {}: write {}",
                              support::bareUnit(formal.type.type.dimension)->spelling, units));
    }
    noteDeclaration(report, "its range is part of the declaration");
    return false;
  }

  /// "`3 h` or `3 day`": the number of an argument without a unit, with those units that bring it
  /// into the range of the formal. Empty: it has a unit, or none does.
  [[nodiscard]] std::string withMissingUnit(const Signature::Formal& formal,
                                            const ast::Argument& argument) const {
    const auto* literal = std::get_if<ast::Literal>(&argument.value->node);
    const auto bare = support::bareUnit(formal.type.type.dimension);
    if (literal == nullptr || !literal->unit.empty() || !bare || bare->spelling.empty()) {
      return "";
    }
    const double number = valueOf(literal->digits);
    constexpr std::array<std::string_view, 6> kUsual = {"s", "min", "h", "day", "m", "km"};
    std::string found;
    for (const support::Unit& unit : support::unitsOf(formal.type.type.dimension)) {
      const double value = number * unit.to_si;
      const bool usual = std::ranges::find(kUsual, unit.spelling) != kUsual.end();
      if (usual && value >= formal.lowest && value <= formal.highest) {
        found +=
            fmt::format("{}`{} {}`", found.empty() ? "" : " or ", literal->digits, unit.spelling);
      }
    }
    return found;
  }

  /// Of a position that was added last, for a latitude and a longitude.
  bool positionInRange(const Step& step) {
    const ir::ExprId longitude = result_.values.back();
    bool inside = true;
    result_.values.pop_back();
    for (size_t half = 0; half < 2; ++half) {
      const Signature::Formal& formal = formals()[step.formal + half];
      if (half == 1) {
        result_.values.push_back(longitude);
      }
      inside = inside && (formal.range == nullptr ||
                          isInRange(formal, arguments_[step.argument], nameOf(formal)));
    }
    return inside;
  }

  [[nodiscard]] bool isKnownAtStart(ir::ExprId id) const {
    return !ir::anyIn(scope_.mission, id, [&](const ir::Expr& e) {
      using enum ir::Op;
      const bool changes = e.op == Sensor || e.op == Age || e.op == MissionTime ||
                           e.op == StateTime || e.op == ResumeTime || e.op == Call ||
                           e.op == Temporal;
      return changes ||
             (e.op == Variable && scope_.mission[e.variable].kind != ir::VariableKind::Parameter);
    });
  }

  /// `300 m`, `-300 m`.
  static bool isNumber(const ast::Expr& expr) {
    const auto* unary = std::get_if<ast::Unary>(&expr.node);
    return std::holds_alternative<ast::Literal>(expr.node) ||
           (unary != nullptr && std::holds_alternative<ast::Literal>(unary->operand->node));
  }

  bool addUsual(const Signature::Formal& formal, const std::string& what) {
    const auto value = lowerUsual(formal, what, where_, scope_);
    if (value) {
      result_.values.push_back(value->id);
    }
    return value.has_value();
  }

  bool add(size_t index, const DeclaredType& type, const std::string& what) {
    const ast::Argument& argument = arguments_[index];
    if (argument.of) {
      scope_.report(support::diagnostics::ofOutsideWindow, argument.of->where, callee_.name);
      return false;
    }
    ExprLowering lowering(scope_);
    if (type.path) {
      auto path = lowering.lowerPath(*argument.value);
      result_.paths.push_back({path.value_or(Path()), argument.value->where});
      return path.has_value();
    }
    const auto value = lowering.lowerDeclared(*argument.value, type, what);
    if (!value) {
      return false;
    }
    result_.values.push_back(value->id);
    if (type.position) {
      result_.values.push_back(value->longitude);
    }
    return true;
  }

  /// Reports a longitude before its latitude, once for both.
  bool longitudeFirst(size_t argument) {
    const bool swapped = argument + 1 < arguments_.size() &&
                         ExprLowering(scope_).longitudeFirst(*arguments_[argument].value,
                                                             *arguments_[argument + 1].value);
    reported_ = swapped ? argument + 1 : reported_;
    return swapped;
  }

  /// Reports `39.175, -73.83`, once for both: what cannot be minutes is degrees.
  bool decimalDegrees(size_t argument) {
    const bool refused = argument + 1 < arguments_.size() &&
                         ExprLowering(scope_).decimalDegrees(*arguments_[argument].value,
                                                             *arguments_[argument + 1].value);
    reported_ = refused ? argument + 1 : reported_;
    return refused;
  }

  /// Whether an argument is a number with a unit of the formal's dimension, or a position for one.
  bool fits(const ast::Argument& argument, const Signature::Formal& formal) {
    if (argument.of || formal.type.position) {
      return formal.type.position && isPosition(*argument.value, scope_);
    }
    const auto* literal = std::get_if<ast::Literal>(&argument.value->node);
    const auto unit = literal == nullptr ? std::nullopt : support::findUnit(literal->unit);
    return unit && formal.type.type == quantity(unit->dimension);
  }

  /// Whether only a comma is between them: neither has the name of its parameter.
  bool isFollowedBy(const ast::Argument& first, const ast::Argument& second) {
    const support::SourceRange between{first.value->where.file, first.value->where.end,
                                       second.value->where.begin};
    return between.begin < between.end &&
           scope_.text(between).find_first_not_of(", \n\t") == std::string::npos;
  }

  /// Reports `climb_to(26 deg, 10 m)`, once for both.
  bool exchanged(const Step& step) {
    if (step.argument + 1 >= arguments_.size() || step.formal + 1 >= formals().size()) {
      return false;
    }
    const ast::Argument& first = arguments_[step.argument];
    const ast::Argument& second = arguments_[step.argument + 1];
    const Signature::Formal& wanted = formals()[step.formal];
    const Signature::Formal& next = formals()[step.formal + 1];
    if (fits(first, wanted) || !fits(first, next) || !fits(second, wanted) ||
        !isFollowedBy(first, second)) {
      return false;
    }
    const std::string_view a = scope_.text(first.value->where);
    const std::string_view b = scope_.text(second.value->where);
    const support::SourceRange both{first.value->where.file, first.value->where.begin,
                                    second.value->where.end};
    scope_.report(support::diagnostics::argumentsExchanged, both, a, b, callee_.signature.text)
        .fix(both, fmt::format("{}, {}", b, a));
    reported_ = step.argument + 1;
    return true;
  }

  static const ast::Binary* differenceIn(const ast::Argument& argument) {
    const auto* binary = std::get_if<ast::Binary>(&argument.value->node);
    return binary != nullptr && binary->op == ast::BinaryOp::Subtract ? binary : nullptr;
  }

  /// `nav(3910.5 -7349.8)`: the vehicle's own latitude and longitude without the comma.
  static bool lacksComma(const ast::Argument& argument) {
    const ast::Binary* difference = differenceIn(argument);
    return difference != nullptr && takesUnitOfContext(*difference->left) &&
           takesUnitOfContext(*difference->right);
  }

  /// Without a fix: for arguments other than a position, the difference may be meant and another
  /// argument missing.
  support::DiagnosticBuilder reportMissingComma(const ast::Argument& argument,
                                                const std::string& takes) {
    const ast::Binary* difference = differenceIn(argument);
    auto report =
        scope_.report(support::diagnostics::missingCommaBeforeMinus, argument.value->where,
                      callee_.name, takes, scope_.text(argument.value->where),
                      scope_.text(difference->left->where), scope_.text(difference->right->where));
    noteDeclaration(report, "declared as `" + callee_.signature.text + "`");
    return report;
  }

  /// Refuses a whole path where positions are expected.
  bool refusePath() {
    for (const ast::Argument& argument : arguments_) {
      const bool wanted = std::ranges::any_of(formals(), [](const auto& f) { return f.type.path; });
      if (!wanted && isPath(*argument.value, scope_)) {
        scope_.report(support::diagnostics::pathAsValue, argument.value->where,
                      scope_.text(argument.value->where));
        return true;
      }
    }
    return false;
  }

  /// The first parameter after the arguments that are given that has no usual value.
  [[nodiscard]] const std::string& firstMissing() const {
    const auto after = formals().begin() + static_cast<std::ptrdiff_t>(filled_);
    return std::find_if(after, formals().end(),
                        [](const Signature::Formal& formal) { return formal.usual == nullptr; })
        ->name->text;
  }

  void wrongCount() {
    const size_t wanted = formals().size();
    const auto needed = static_cast<size_t>(std::ranges::count(
        formals(), nullptr, [](const Signature::Formal& formal) { return formal.usual; }));
    const std::string takes =
        needed == wanted
            ? countOf(wanted)
            : fmt::format("{} {} {}", needed, needed + 1 == wanted ? "or" : "to", countOf(wanted));
    for (const ast::Argument& argument : arguments_) {
      if (differenceIn(argument) != nullptr && filled_ + 1 == wanted) {
        reportMissingComma(argument, takes);
        return;
      }
    }
    if (filled_ >= needed && filled_ < wanted) {  // enough, but not those that are needed
      auto report = scope_.report(support::diagnostics::argumentMissing, where_, callee_.name,
                                  firstMissing());
      noteDeclaration(report, "declared here");
      return;
    }
    auto report =
        scope_.report(support::diagnostics::wrongArgumentCount, where_, callee_.name, takes,
                      arguments_.empty() ? "none" : countOf(filled_), callee_.signature.text);
    noteDeclaration(report, "declared here");
  }

  void noteDeclaration(support::DiagnosticBuilder& report, const std::string& message) {
    if (callee_.declared != nullptr) {
      report.note(callee_.declared->where, message);
    }
  }

  const std::vector<ast::Argument>& arguments_;
  const Callee& callee_;
  const support::SourceRange& where_;
  Scope& scope_;
  std::vector<Step> steps_;
  size_t reported_ = SIZE_MAX;  ///< the argument that has already been reported
  size_t filled_ = 0;           ///< arguments, with a position for two formals counted twice
  Arguments result_;
};

}  // namespace

bool isLatitudeAndLongitude(const Signature& signature, size_t formal) {
  const auto& formals = signature.formals;
  return formal + 1 < formals.size() && formals[formal].type == DeclaredType{latitude(), false} &&
         formals[formal + 1].type == DeclaredType{longitude(), false};
}

std::optional<Arguments> lowerArguments(const std::vector<ast::Argument>& arguments,
                                        const Callee& callee, const support::SourceRange& where,
                                        Scope& scope) {
  if (refuseOtherSlope(arguments, callee, scope) || refuseEquals(arguments, callee, scope)) {
    return std::nullopt;
  }
  const auto named = [](const ast::Argument& argument) { return argument.parameter.has_value(); };
  if (std::ranges::none_of(arguments, named)) {
    return ArgumentLowering(arguments, callee, where, scope).run();
  }
  const auto ordered = inOrder(arguments, callee, where, scope);
  return ordered ? ArgumentLowering(*ordered, callee, where, scope).run() : std::nullopt;
}

std::optional<Value> lowerUsual(const Signature::Formal& formal, const std::string& what,
                                const support::SourceRange& where, Scope& scope) {
  if (!formal.usual->where.valid()) {
    return ExprLowering(scope).usualSlope(scope.platform().envelope.steersBySpeed(), where);
  }
  Context context;
  context.isolated = true;
  context.constant = "a usual argument";
  const Scope::Within within(scope, context);
  return ExprLowering(scope).lowerDeclared(*formal.usual, formal.type, what);
}

bool refuseOtherSlope(const std::vector<ast::Argument>& arguments, const Callee& callee,
                      Scope& scope) {
  const bool speed = scope.platform().envelope.steersBySpeed();
  const auto& told = speed ? support::dimension::speed : support::dimension::angle;
  const bool takes = std::ranges::any_of(callee.signature.formals, [&](const auto& formal) {
    return formal.usual != nullptr && formal.type.type == quantity(told);
  });
  const auto& other = speed ? support::dimension::angle : support::dimension::speed;
  const auto wrong = std::ranges::find_if(
      arguments, [&](const ast::Argument& argument) { return isLiteralOf(argument, other); });
  if (!takes || wrong == arguments.end()) {
    return false;
  }
  scope.report(support::diagnostics::otherSlope, wrong->value->where, scope.platform().name,
               speed ? "goes to a depth at a speed, not at a pitch"
                     : "goes to a depth at a pitch, not at a speed",
               scope.text(wrong->value->where),
               fmt::format("leave it out, or write `{}`", callee.signature.text));
  return true;
}

}  // namespace glider::frontend
