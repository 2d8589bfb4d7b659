// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/lower_resumption.h"

#include "frontend/sema/declared_value.h"

#include <optional>

namespace glider::frontend {

using support::DiagnosticId;

namespace {

/// The longest outage, s; empty, and reported, if that is no time above 0.
std::optional<double> longestOutage(const ast::Resumption& node, Scope& scope) {
  const DeclaredType time{quantity(support::dimension::time)};
  const ast::Name role{"resume within", node.where};
  const auto known =
      DeclaredValue(role, time, scope).constant(node.within, "the time of `resume within`");
  if (known && !(known->first > 0)) {
    scope.report(DiagnosticId::requirementTime, node.within.where, "resume within",
                 scope.text(node.within.where));
    return std::nullopt;
  }
  return known ? std::optional(known->first) : std::nullopt;
}

}  // namespace

void lowerResumption(const ast::File& file, Scope& scope) {
  const ast::Resumption* first = nullptr;
  for (const ast::Item& item : file.items) {
    const auto* node = std::get_if<ast::Resumption>(&item);
    if (node == nullptr) {
      continue;
    }
    if (first != nullptr) {
      scope.report(DiagnosticId::memberTwice, node->where, "a mission", "resume");
      continue;
    }
    first = node;
    scope.mission.new_after_restart = node->never_after_restart;
    if (const auto within = longestOutage(*node, scope)) {
      scope.mission.resume_within_s = *within;
    }
  }
}

}  // namespace glider::frontend
