// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/leaving.h"
#include "ir/prove/context/state_bounds.h"

#include <vector>

namespace glider::ir::prove {

/// For each state. `end`: of `proof_context`.
///
/// - A state is not current before earliestEntries, nor after EndBound::left_by.
/// - It is left a certain time after it became current, whenever that was (stayOf): `resumetime`
///   does not exceed that. Nor does `statetime` if the state never waits for a return.
/// - deepestByState bounds the depth.
std::vector<StateBounds> boundsOfStates(const ProofContext& proof_context, const EndBound& end);
/// The same for each state that may become current.
std::vector<StateBounds> stateBounds(const ProofContext& proof_context, const EndBound& end);
/// Those of boundsOfStates whose state may become current.
std::vector<StateBounds> ofPossibleStates(std::vector<StateBounds> all, const EndBound& end);

/// Whether a state may wait for a return. One that never does becomes current only when it is
/// entered.
bool mayWait(const Mission& mission, StateId state);

/// The cases of `always` that may fire after any transitions before, so that they certainly fire
/// where they are true. Without a target no state keeps them from firing (L1). Case j of `always`
/// that leads to a state sets the limit to j (L3): it keeps itself and all cases after it from
/// firing, so these are the cases before the first of those.
Cases neverPrevented(const Mission& mission);

/// For each state the greatest limit with which it may be current (L2 to L4): case i of `always`
/// does not fire there if i is no less. 0 for a state that is never entered.
std::vector<size_t> greatestLimits(const Mission& mission);

/// Every value that the variables may have.
Valuation anyValues(const Mission& mission);

}  // namespace glider::ir::prove
