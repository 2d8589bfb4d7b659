// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A note on a refuted requirement that no mission can keep, since only the sea and the vehicle
// decide what it speaks of (GL3110). In: the requirement; out: the note, or none.

#include "ir/core/walk.h"
#include "ir/prove/context/decided_by_mission.h"
#include "ir/prove/requirements/advice.h"

#include <fmt/format.h>

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

}  // namespace

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
