// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A note on a refuted requirement that no mission can keep, since only the sea and the vehicle
// decide what it speaks of (GL3110). In: the requirement; out: the note, or none.

#include "ir/core/walk.h"
#include "ir/prove/context/decided_by_mission.h"
#include "ir/prove/requirements/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace glider::ir::prove {
namespace {

/// A reading of the condition that the sea decides, if it reads nothing else; else empty.
std::string onlyOfTheSea(ExprId condition, const ProofContext& proof_context) {
  const Mission& mission = proof_context.mission;
  std::string reading;
  const bool others = anyIn(mission, condition, [&](const Expr& e) {
    if (e.op == Op::Sensor && deciderOf(mission, proof_context.platform, e) == Decider::Sea) {
      reading = mission[e.sensor].name;
      return false;
    }
    return e.op != Op::Constant && !e.operands[0].valid();
  });
  return others ? "" : reading;
}

bool setsToFalse(const Mission& mission, BlockId block) {
  return std::ranges::any_of(mission[block].statements, [&](const Statement& s) {
    return s.kind == StatementKind::Set && mission[s.value].op == Op::False;
  });
}

/// A reading other than the depth for which a promise waits: its monitor clears what is owed where
/// a condition of that reading holds. Empty: none.
std::string awaitedReading(const Requirement& requirement, const ProofContext& proof_context) {
  const Mission& mission = proof_context.mission;
  std::string reading;
  forEachStatement(mission, requirement.monitor.step, [&](const Statement& s) {
    if (s.kind != StatementKind::If || !s.then.valid() || !setsToFalse(mission, s.then)) {
      return;
    }
    forEachIn(mission, s.value, [&](const Expr& e) {
      if (e.op == Op::Sensor && proof_context.depth != e.sensor) {
        reading = mission[e.sensor].name;
      }
    });
  });
  return reading;
}

}  // namespace

void noteAwaitedReading(support::DiagnosticBuilder& error, const Requirement& requirement,
                        const Counterexample& run, const ProofContext& proof_context) {
  const std::string reading = run.due.empty() ? "" : awaitedReading(requirement, proof_context);
  if (!reading.empty()) {
    error.note(requirement.range,
               fmt::format("`{}` is a reading, which may be missing or wrong for any time, so no "
                           "mission can ensure that it shows this: require a state, a variable of "
                           "the mission{}",
                           reading,
                           proof_context.depth ? ", or the true depth, as in `then depth <= 2 m "
                                                 "within …`"
                                               : ""));
  }
}

void noteWhatTheSeaDecides(support::DiagnosticBuilder& error, const Requirement& requirement,
                           const ProofContext& proof_context) {
  const bool plain = requirement.kind == RequirementKind::Always && requirement.seconds == 0 &&
                     !requirement.monitor.step.valid() && requirement.condition.valid();
  const std::string reading = plain ? onlyOfTheSea(requirement.condition, proof_context) : "";
  if (!reading.empty()) {
    error.note(
        requirement.range,
        fmt::format("the sea and the vehicle decide what `{0}` is, so no mission can ensure "
                    "this: require what the mission does then (`require whenever {0} … then "
                    "STATE within …`), or state what is known of it (`assume {0} in LOWEST .. "
                    "HIGHEST`)",
                    reading));
  }
}

}  // namespace glider::ir::prove
