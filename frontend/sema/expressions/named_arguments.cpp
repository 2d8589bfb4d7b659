// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/named_arguments.h"

#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/functions.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace glider::frontend {
namespace {

/// "parameters: top, bottom, dive, climb"
Suggestion namesOf(const Signature& signature, std::string_view wrong) {
  std::vector<std::string_view> names;
  std::string all;
  for (const Signature::Formal& formal : signature.formals) {
    names.push_back(formal.name->text);
    all += (all.empty() ? "parameters: " : ", ") + formal.name->text;
  }
  return didYouMean(wrong, names, names.empty() ? "it has no parameters" : all);
}

/// What an argument of a behaviour of the vehicle's, or another word, is called here: "bottom" for
/// "d_target_depth"; empty if nothing is known.
std::string_view parameterMeantBy(std::string_view word) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"d_target_depth", "bottom"},
      {"target_depth", "bottom"},
      {"max_depth", "bottom"},
      {"maximum_depth", "bottom"},
      {"depth", "bottom"},
      {"deepest", "bottom"},
      {"c_target_depth", "top"},
      {"min_depth", "top"},
      {"minimum_depth", "top"},
      {"shallowest", "top"},
      {"d_target_altitude", "above"},
      {"altitude", "above"},
      {"min_altitude", "above"},
      {"d_pitch_value", "dive"},
      {"dive_pitch", "dive"},
      {"dive_angle", "dive"},
      {"c_pitch_value", "climb"},
      {"climb_pitch", "climb"},
      {"climb_angle", "climb"},
      {"num_half_cycles_to_do", "times"},
      {"count", "times"},
      {"repeat", "times"}};
  const auto* found =
      std::ranges::find(kWords, word, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kWords) ? std::string_view() : found->second;
}

/// Puts arguments of which some are named in the order of the parameters.
class Ordering {
 public:
  Ordering(const std::vector<ast::Argument>& arguments, const Callee& callee, Scope& scope)
      : arguments_(arguments),
        callee_(callee),
        scope_(scope),
        places_(callee.signature.formals.size() + arguments.size()) {}

  std::optional<std::vector<ast::Argument>> run(const support::SourceRange& where) {
    for (size_t i = 0; i < arguments_.size(); ++i) {
      if (arguments_[i].parameter) {
        named_ = true;
        takeNamed(arguments_[i]);
      } else {
        takeUnnamed(i);
      }
    }
    return good_ ? ordered(where) : std::nullopt;
  }

 private:
  /// What was given for a parameter: a position may be a latitude and a longitude, and one position
  /// may be for the two.
  struct Place {
    std::vector<const ast::Argument*> given;
    bool covered = false;  ///< by the position that was given for the latitude before
    [[nodiscard]] bool filled() const { return covered || !given.empty(); }
  };

  [[nodiscard]] const std::vector<Signature::Formal>& formals() const {
    return callee_.signature.formals;
  }

  void takeNamed(const ast::Argument& argument) {
    const auto found =
        std::ranges::find(formals(), argument.parameter->text,
                          [](const Signature::Formal& formal) { return formal.name->text; });
    const std::string_view meant = parameterMeantBy(argument.parameter->text);
    const bool takes = std::ranges::any_of(
        formals(), [&](const Signature::Formal& formal) { return formal.name->text == meant; });
    if (found == formals().end() && takes) {
      scope_
          .report(support::diagnostics::unknownParameter, argument.parameter->where, callee_.name,
                  argument.parameter->text, fmt::format("write `{} = …`", meant))
          .fix(argument.parameter->where, std::string(meant));
      good_ = false;
      return;
    }
    if (found == formals().end()) {
      scope_.reportUnknown(support::diagnostics::unknownParameter, argument.parameter->where,
                           namesOf(callee_.signature, argument.parameter->text), callee_.name,
                           argument.parameter->text);
      good_ = false;
      return;
    }
    Place& place = places_[static_cast<size_t>(found - formals().begin())];
    if (place.filled()) {
      scope_.report(support::diagnostics::argumentTwice, argument.parameter->where, callee_.name,
                    argument.parameter->text);
      good_ = false;
    }
    place.given = {&argument};
  }

  void takeUnnamed(size_t index) {
    const ast::Argument& argument = arguments_[index];
    if (named_) {
      scope_.report(support::diagnostics::orderAfterName, argument.value->where,
                    scope_.text(argument.value->where));
      good_ = false;
      return;
    }
    places_[next_].given.push_back(&argument);
    const bool position = isPosition(*argument.value, scope_);
    const bool first_half = next_ < formals().size() && places_[next_].given.size() == 1 &&
                            formals()[next_].type.position && !position &&
                            arguments_.size() - index > formals().size() - next_;
    if (first_half) {
      return;  // the longitude follows
    }
    const bool pair = position && isLatitudeAndLongitude(callee_.signature, next_);
    places_[next_ + 1].covered = pair;
    next_ += pair ? 2 : 1;
  }

  std::optional<std::vector<ast::Argument>> ordered(const support::SourceRange& where) {
    std::vector<ast::Argument> all;
    for (size_t i = 0; i < formals().size(); ++i) {
      if (!places_[i].filled() && formals()[i].usual != nullptr) {
        all.push_back({*formals()[i].usual, {}, {}});
        continue;
      }
      if (!places_[i].filled()) {
        scope_.report(support::diagnostics::argumentMissing, where, callee_.name,
                      formals()[i].name->text);
        return std::nullopt;
      }
      for (const ast::Argument* argument : places_[i].given) {
        all.push_back({argument->value, argument->of, {}});
      }
    }
    return all;
  }

  const std::vector<ast::Argument>& arguments_;
  const Callee& callee_;
  Scope& scope_;
  std::vector<Place> places_;
  size_t next_ = 0;
  bool named_ = false;
  bool good_ = true;
};

/// `top == 3 m` for `top = 3 m`: the comparison, if its left side is a parameter and no value.
const ast::Binary* equalsForName(const ast::Argument& argument, const Callee& callee,
                                 Scope& scope) {
  const auto* comparison = std::get_if<ast::Binary>(&argument.value->node);
  const auto* use = comparison != nullptr && comparison->op == ast::BinaryOp::Equal
                        ? std::get_if<ast::NameUse>(&comparison->left->node)
                        : nullptr;
  if (argument.parameter || use == nullptr || scope.declares(use->name, argument.value->where) ||
      scope.findSensor(use->name) != nullptr || !scope.takenBy(use->name).empty()) {
    return nullptr;
  }
  const bool parameter = std::ranges::any_of(
      callee.signature.formals,
      [&](const Signature::Formal& formal) { return formal.name->text == use->name; });
  return parameter ? comparison : nullptr;
}

}  // namespace

bool refuseEquals(const std::vector<ast::Argument>& arguments, const Callee& callee, Scope& scope) {
  bool refused = false;
  for (const ast::Argument& argument : arguments) {
    if (const ast::Binary* comparison = equalsForName(argument, callee, scope)) {
      scope.report(support::diagnostics::equalForAssign, comparison->op_where)
          .hint(fmt::format("write `{} = {}`", scope.text(comparison->left->where),
                            scope.text(comparison->right->where)))
          .fix(comparison->op_where, "=");
      refused = true;
    }
  }
  return refused;
}

std::optional<std::vector<ast::Argument>> inOrder(const std::vector<ast::Argument>& arguments,
                                                  const Callee& callee,
                                                  const support::SourceRange& where, Scope& scope) {
  return Ordering(arguments, callee, scope).run(where);
}

bool refuseNames(const ast::Invocation& node, Scope& scope) {
  for (const ast::Argument& argument : node.arguments) {
    if (argument.parameter) {
      const auto texts = functionTexts();
      const auto found = std::ranges::find(texts, node.function.text, &FunctionText::name);
      scope.report(support::diagnostics::namedArgument, argument.parameter->where,
                   node.function.text,
                   found != texts.end() ? std::string(found->use)
                                        : fmt::format("{}(…)", node.function.text));
      return true;
    }
  }
  return false;
}

}  // namespace glider::frontend
