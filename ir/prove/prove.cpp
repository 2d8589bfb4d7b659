// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/prove.h"

#include "ir/prove/passes.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace glider::ir::prove {
namespace {

std::map<CasePlace, bool> deadOf(const Proof& proof) {
  std::map<CasePlace, bool> cases;
  for (const CasePlace& place : proof.dead) {
    cases.emplace(place, proof.hidden.contains(place));
  }
  return cases;
}

/// A flight that reaches a state does so under any assumptions, unless it starts deeper than
/// vehicles usually do.
void nameDeepStarts(Findings& findings, const WrittenWorld& usual) {
  const auto& [mission, platform] = usual;
  for (RequirementVerdict& verdict : findings.requirements) {
    const bool deep = verdict.verdict == Verdict::Proved && verdict.run &&
                      verdict.run->ticks.front().depth > platform.world.start_depth_m;
    for (uint32_t i = 0; deep && i < mission.assumptions.size(); ++i) {
      if (mission.assumptions[i].kind == AssumptionKind::StartDepth) {
        verdict.assumptions.push_back(i);
      }
    }
  }
}

}  // namespace

const char* word(Verdict verdict) {
  switch (verdict) {
    case Verdict::Proved:
      return "proved";
    case Verdict::Refuted:
      return "refuted";
    case Verdict::Open:
      return "undecided";
  }
  return "";
}

const char* word(Method method) {
  switch (method) {
    case Method::Invariant:
      return "invariant";
    case Method::Bound:
      return "bound";
    case Method::Configurations:
      return "configurations";
    case Method::Run:
      return "run";
    case Method::Energy:
      return "energy";
    case Method::Geometry:
      return "geometry";
  }
  return "";
}

std::string premisesOf(const RequirementVerdict& verdict, const Mission& mission) {
  std::string line;
  for (const uint32_t number : verdict.assumptions) {
    line += fmt::format("{}`{}`", line.empty() ? "assuming " : ", ",
                        mission.assumptions.at(number).words);
  }
  const char* between = line.empty() || verdict.premise.empty() ? "" : "; ";
  return line + between + verdict.premise;
}

Findings prove(const Worlds& worlds, const MissionFacts& facts, const Options& options,
               support::DiagnosticEngine& diagnostics) {
  const ProofContext proof_context(worlds.widest);
  z3::context context;
  Proof proof{context, worlds, proof_context, facts, options, diagnostics};
#define PASS(name, purpose) passes::name(proof);
#include "ir/prove/prove_passes.def"
#undef PASS
  proof.findings.never_fire = deadOf(proof);
  nameDeepStarts(proof.findings, worlds.written);
  return std::move(proof.findings);
}

std::map<CasePlace, bool> casesThatNeverFire(const Worlds& worlds, const MissionFacts& facts,
                                             const Options& options) {
  const ProofContext proof_context(worlds.written);
  z3::context context;
  support::DiagnosticEngine unheard;
  Proof proof{context, worlds, proof_context, facts, options, unheard};
  passes::guards(proof);
  return deadOf(proof);
}

}  // namespace glider::ir::prove
