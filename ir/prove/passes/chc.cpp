// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Not a pass: the prover's questions as text, for other solvers (`glidercc build --emit chc`). In:
// a mission with its assumptions; out: one script of SMT-LIB 2 for each requirement, in the logic
// HORN. They are the clauses that `requirements` asks Spacer about, without the bounds that the
// other methods add first. A requirement that is not about traces (a call depth, a geofence)
// becomes a comment.

#include "ir/prove/chc.h"

#include "ir/prove/encoding/horn_clauses.h"
#include "ir/prove/encoding/safety_properties.h"

#include <fmt/format.h>

namespace glider::ir::prove {
namespace {

/// A relation, as SMT-LIB declares it.
std::string declared(const z3::func_decl& relation) {
  std::string sorts;
  for (unsigned i = 0; i < relation.arity(); ++i) {
    sorts += fmt::format("{}{}", i == 0 ? "" : " ", relation.domain(i).to_string());
  }
  return fmt::format("(declare-fun {} ({}) Bool)\n", relation.name().str(), sorts);
}

/// Empty if there are too many call stacks.
std::string problem(const Requirement& requirement, const ProofContext& proof_context) {
  z3::context context;
  const ConeOfInfluence relevance = relevanceOf(requirement, proof_context);
  const SafetyProperty property = safetyPropertyFor(requirement, context, proof_context, relevance);
  ChcEncoder encoder(context, proof_context, relevance, property);
  if (!encoder.run()) {
    return "";
  }
  const HornClauses clauses(context, encoder.rules());
  std::string text = "(set-logic HORN)\n";
  for (const auto& [place, relation] : clauses.relations()) {
    text += declared(relation);
  }
  for (const Rule& rule : encoder.rules()) {
    text += fmt::format("(assert {})\n", clauses.clause(rule, context.bool_val(false)).to_string());
  }
  return text + "(check-sat)\n";
}

}  // namespace

std::string chcText(const AssumedWorld& world, const std::function<std::string(uint32_t)>& words) {
  const Mission& mission = world.mission;
  const ProofContext proof_context(world);
  std::string text;
  for (uint32_t i = 0; i < mission.requirements.size(); ++i) {
    const Requirement& requirement = mission.requirements[i];
    const bool of_traces =
        requirement.kind != RequirementKind::StackAtMost && requirement.geofences.empty();
    const std::string asked = of_traces ? problem(requirement, proof_context) : "";
    text += fmt::format("{}; {}{}\n{}", i == 0 ? "" : "(reset)\n", words(i),
                        !of_traces      ? ": not a question about traces"
                        : asked.empty() ? ": too many call stacks"
                                        : "",
                        asked);
  }
  return text;
}

}  // namespace glider::ir::prove
