// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lanes.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

namespace glider::frontend {

/// `lanes(area, 500 m)`.
std::optional<Path> ExprLowering::lanes(const ast::Invocation& node, const ast::Expr& expr) {
  if (stretched(node)) {
    return std::nullopt;
  }
  if (node.arguments.size() != 2) {
    scope_.report(support::diagnostics::wrongArgumentCount, expr.where, node.function.text,
                  "2 arguments",
                  node.arguments.empty() ? "none" : fmt::format("{}", node.arguments.size()),
                  "lanes(area, 500 m)");
    return std::nullopt;
  }
  const ast::Expr& area = *node.arguments.front().value;
  const size_t before = scope_.mission.exprs.size();
  const auto corners = lowerPath(area);
  const auto spacing =
      positiveConstant(*node.arguments.back().value, quantity(support::dimension::length),
                       {"the spacing of `lanes`", "it is the spacing of lanes here",
                        support::diagnostics::lanesSpacing});
  scope_.mission.exprs.resize(before);
  if (!corners || !spacing) {
    return std::nullopt;
  }
  if (scope_.context.checkedAlone()) {
    return corners;  // the arguments are not known here
  }
  auto laid = layLanes(*corners, *spacing);
  if (!laid) {
    refuseLanes(laid.error(), area);
    return std::nullopt;
  }
  return std::move(*laid);
}

/// Reports at the place where the area is written or, in a behaviour, where it is given.
void ExprLowering::refuseLanes(const LaneProblem& problem, const ast::Expr& area) {
  const auto* use = std::get_if<ast::NameUse>(&area.node);
  const Named* named = use != nullptr ? scope_.findNamed(use->name) : nullptr;
  const support::SourceRange where = named != nullptr ? named->path.where : area.where;
  const std::string text = scope_.text(where);
  support::DiagnosticEngine& diagnostics = scope_.diagnostics();
  switch (problem.kind) {
    case LaneProblem::Kind::Line:
      diagnostics.report(support::diagnostics::lanesOfLine, where, text);
      return;
    case LaneProblem::Kind::TooFar:
      diagnostics.report(support::diagnostics::lanesTooFar, where, text, problem.metres / 1000,
                         kFarthestCorner / 1000);
      return;
    case LaneProblem::Kind::TooMany:
      diagnostics.report(support::diagnostics::tooManyLanes, where, text, kMostLanes,
                         problem.metres);
      return;
  }
}

}  // namespace glider::frontend
