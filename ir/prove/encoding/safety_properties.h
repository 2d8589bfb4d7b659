// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/horn.h"

namespace glider::ir::prove {

/// The safety property for a requirement: the trace that it forbids, or for Reach the trace that it
/// requires. Not for StackAtMost, which follows from the structure. All must outlive it.
SafetyProperty safetyPropertyFor(const Requirement& requirement, z3::context& context,
                                 const ProofContext& proof_context,
                                 const ConeOfInfluence& relevance);

/// Whether a monitor observes a state.
bool observes(const Monitor& monitor, StateId state);

/// The depths (m) with which the monitor of a requirement compares the true depth, as low as they
/// may be.
std::vector<double> awaitedDepths(const Requirement& requirement,
                                  const ProofContext& proof_context);

/// Whether the answer depends on the depth of the vehicle.
bool reckonsWithDepth(const Requirement& requirement, const ProofContext& proof_context);

/// The cone of influence of the question about a requirement.
ConeOfInfluence relevanceOf(const Requirement& requirement, const ProofContext& proof_context);

/// The same with the vehicle's depth: a larger question, whose traces are of possible vehicles.
ConeOfInfluence withVehicle(const Requirement& requirement, const ProofContext& proof_context);

/// The cone of influence of the question about a requirement within a scope.
ConeOfInfluence relevanceWithin(const Requirement& requirement, const ProofContext& proof_context);

/// Whether the depth that the vehicle reports is in a cone of influence.
bool readsDepth(const ConeOfInfluence& relevance, const ProofContext& proof_context);

}  // namespace glider::ir::prove
