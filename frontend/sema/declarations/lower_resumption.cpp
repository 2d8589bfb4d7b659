// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/lower_resumption.h"

#include "frontend/sema/declarations/declared_value.h"
#include "frontend/sema/declarations/only_item.h"
#include "support/diagnostics/ids/meaning.h"

#include <optional>

namespace glider::frontend {

namespace {

/// The longest outage, s; empty, and reported, if it is not a time above 0.
std::optional<double> longestOutage(const ast::Resumption& node, Scope& scope) {
  const DeclaredType time{quantity(support::dimension::time)};
  const ast::Name role{"resume within", node.where};
  const auto known =
      DeclaredValue(role, time, scope).constant(node.within, "the time of `resume within`");
  if (known && !(known->first > 0)) {
    scope.report(support::diagnostics::requirementTime, node.within.where, "resume within",
                 scope.text(node.within.where));
    return std::nullopt;
  }
  return known ? std::optional(known->first) : std::nullopt;
}

}  // namespace

void lowerResumption(const ast::File& file, Scope& scope) {
  const auto* line = onlyItem<ast::Resumption>(file, [&](const auto& again, const auto&) {
    scope.report(support::diagnostics::memberTwice, again.where, "a mission", "resume");
  });
  if (line == nullptr) {
    return;
  }
  scope.mission.new_after_restart = line->never_after_restart;
  if (const auto within = longestOutage(*line, scope)) {
    scope.mission.resume_within_s = *within;
  }
}

}  // namespace glider::frontend
