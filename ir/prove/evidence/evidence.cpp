// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/evidence/evidence.h"

#include "ir/prove/encoding/safety_properties.h"
#include "ir/prove/evidence/configurations.h"
#include "ir/prove/evidence/formula.h"

#include <map>
#include <string>

namespace glider::ir::prove {
namespace {

std::string both(const std::string& a, const std::string& b) {
  FormulaParts parts;
  parts.add(a);
  parts.add(b);
  return parts.all();
}

/// Whether the invariants of a proof of `from` speak only of what certificates for `to` have too.
bool mayUse(RequirementKind from, RequirementKind to) {
  const bool plain = from == RequirementKind::Always || from == RequirementKind::ExitWithin;
  return plain || (from == to && from == RequirementKind::SurfacesEvery);
}

}  // namespace

Evidence EvidenceBuilder::searched(const Requirement& requirement, Invariants found) {
  for (certify::Invariant& invariant : found) {
    invariant.formula = both(known_.in(invariant.at), invariant.formula);
    if (reckonsWithDepth(requirement, proof_context_)) {
      invariant.formula = both(known_.climbIn(invariant.at), invariant.formula);
    }
  }
  Evidence evidence{Method::Invariant, found};
  addLearnt(requirement, evidence.invariants);
  if (!requirement.monitor.step.valid()) {  // whose variables only its own certificate has
    learnt_.emplace_back(requirement.kind, std::move(found));
  }
  return evidence;
}

/// A configuration that one of them does not list cannot be reached.
void EvidenceBuilder::addLearnt(const Requirement& requirement, Invariants& invariants) const {
  for (const auto& [kind, learnt] : learnt_) {
    if (!mayUse(kind, requirement.kind)) {
      continue;
    }
    std::map<certify::Configuration, std::string> formulas;
    for (const certify::Invariant& one : learnt) {
      formulas.emplace(one.at, one.formula);
    }
    std::erase_if(invariants, [&](const auto& one) { return !formulas.contains(one.at); });
    for (certify::Invariant& one : invariants) {
      one.formula = both(one.formula, formulas.at(one.at));
    }
  }
}

std::optional<EvidenceBuilder::Invariants> EvidenceBuilder::everywhere(
    const Requirement& requirement) const {
  const auto all = configurations(proof_context_.mission);
  if (!all) {
    return std::nullopt;
  }
  Invariants invariants;
  for (const Reached& reached : *all) {
    const certify::Configuration at = configurationOf(reached.control);
    const bool surfaces = requirement.kind == RequirementKind::SurfacesEvery;
    invariants.push_back(
        {at, surfaces ? both(known_.in(at), known_.surfacedIn(at)) : known_.in(at)});
  }
  return invariants;
}

/// Where `after` may have been entered on the way, the invariant says nothing of it.
std::optional<Evidence> EvidenceBuilder::neverAfter(const Requirement& requirement) const {
  const auto all = configurations(proof_context_.mission, requirement.after);
  if (!all) {
    return std::nullopt;
  }
  std::map<certify::Configuration, bool> entered;
  for (const Reached& reached : *all) {
    bool& after = entered[configurationOf(reached.control)];
    after = after || reached.after;
  }
  Invariants invariants;
  for (const auto& [at, after] : entered) {
    invariants.push_back({at, after ? "true" : "(not |after seen|)"});
  }
  return Evidence{Method::Configurations, std::move(invariants)};
}

std::optional<Evidence> EvidenceBuilder::bound(const Requirement& requirement, bool learnt) const {
  auto invariants = everywhere(requirement);
  if (!invariants) {
    return std::nullopt;
  }
  if (learnt) {
    addLearnt(requirement, *invariants);
  }
  return Evidence{Method::Bound, std::move(*invariants)};
}

std::optional<Evidence> EvidenceBuilder::callDepth(const Requirement& requirement) const {
  auto invariants = everywhere(requirement);
  return invariants ? std::optional(Evidence{Method::Configurations, std::move(*invariants)})
                    : std::nullopt;
}

}  // namespace glider::ir::prove
