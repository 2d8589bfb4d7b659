// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/named_arguments.h"

#include "frontend/sema/names/functions.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

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

}  // namespace

std::optional<std::vector<ast::Argument>> inOrder(const std::vector<ast::Argument>& arguments,
                                                  const Callee& callee,
                                                  const support::SourceRange& where, Scope& scope) {
  const auto& formals = callee.signature.formals;
  std::vector<const ast::Argument*> places(std::max(formals.size(), arguments.size()), nullptr);
  bool good = true;
  bool named = false;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const ast::Argument& argument = arguments[i];
    size_t place = i;
    if (argument.parameter) {
      named = true;
      const auto found =
          std::ranges::find(formals, argument.parameter->text,
                            [](const Signature::Formal& formal) { return formal.name->text; });
      if (found == formals.end()) {
        scope.reportUnknown(support::diagnostics::unknownParameter, argument.parameter->where,
                            namesOf(callee.signature, argument.parameter->text), callee.name,
                            argument.parameter->text);
        good = false;
        continue;
      }
      place = static_cast<size_t>(found - formals.begin());
      if (places[place] != nullptr) {
        scope.report(support::diagnostics::argumentTwice, argument.parameter->where, callee.name,
                     argument.parameter->text);
        good = false;
      }
    } else if (named) {
      scope.report(support::diagnostics::orderAfterName, argument.value->where,
                   scope.text(argument.value->where));
      good = false;
    }
    places[place] = &argument;
  }
  std::vector<ast::Argument> ordered;
  for (size_t i = 0; i < formals.size() && good; ++i) {
    if (places[i] == nullptr) {
      scope.report(support::diagnostics::argumentMissing, where, callee.name,
                   formals[i].name->text);
      good = false;
    } else {
      ordered.push_back({places[i]->value, places[i]->of, {}});
    }
  }
  return good ? std::optional(std::move(ordered)) : std::nullopt;
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
