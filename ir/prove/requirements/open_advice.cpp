// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Notes on a requirement that is undecided. In: the warning that is being reported, and the
// mission; out: notes on that warning. Used by requirement_check.cpp (GL3111).

#include "ir/core/walk.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/requirements/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace glider::ir::prove {
namespace {

/// The variables of the mission that are counted up or down without a limit: set from themselves,
/// with a range that has no end.
std::vector<VariableId> unlimitedCounts(const Mission& m) {
  std::vector<VariableId> found;
  for (const Block& block : m.blocks) {
    for (const Statement& statement : block.statements) {
      if (statement.kind != StatementKind::Set) {
        continue;
      }
      const Variable& variable = m[statement.variable];
      const bool unlimited = std::isinf(variable.lowest) || std::isinf(variable.highest);
      const bool counts = anyIn(m, statement.value, [&](const Expr& e) {
        return e.op == Op::Variable && e.variable == statement.variable;
      });
      if (variable.kind == VariableKind::Mission && variable.type.kind == TypeKind::Quantity &&
          unlimited && counts && std::ranges::find(found, statement.variable) == found.end()) {
        found.push_back(statement.variable);
      }
    }
  }
  return found;
}

}  // namespace

void notePowerCutsCount(support::DiagnosticBuilder& warning, const Requirement& requirement,
                        const ProofContext& proof_context, Ending& ending) {
  const EndBound& always_powered = ending.boundWithoutPowerCuts();
  if (!always_powered.by || *always_powered.by > requirement.seconds) {
    return;
  }
  const EndBound& end = ending.bound();
  if (end.by && *end.by > requirement.seconds) {
    warning.note(
        requirement.range,
        fmt::format("power cuts of the SBC of up to {} count, too: by its clocks, the "
                    "mission ends after at most {}; require that, or `assume no outage`",
                    durationOf(proof_context.mission.resume_within_s), durationOf(*end.by)));
  }
}

void noteUnlimitedCounts(support::DiagnosticBuilder& warning, const ProofContext& proof_context) {
  constexpr size_t kMostNotes = 3;
  const Mission& m = proof_context.mission;
  const std::vector<VariableId> counts = unlimitedCounts(m);
  for (size_t i = 0; i < std::min(counts.size(), kMostNotes); ++i) {
    warning.note(
        m[counts[i]].range,
        fmt::format("`{}` is counted without a limit, and few proofs succeed then: give it "
                    "a range such as `in 0 .. 100`, and keep it there with `min` or `clamp`",
                    m[counts[i]].name));
  }
}

}  // namespace glider::ir::prove
