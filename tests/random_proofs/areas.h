// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/proof_context.h"
#include "tests/random_proofs/conditions.h"

namespace glider::random_proofs {

/// None if the mission steers to no waypoint, to waypoints far apart, or is not known to end.
std::optional<Track> trackOf(const ir::prove::ProofContext& context, ir::prove::Ending& ending);

/// Makes `requirement` an area about as large as the track needs, to stay in; or one as far from
/// it, to stay out of. False if the mission does not read its position.
bool writeArea(ir::Mission& mission, ir::Requirement& requirement, const Track& track,
               Conditions& conditions, random_missions::Random& random);

/// The same for a disc.
bool writeDisc(ir::Mission& mission, ir::Requirement& requirement, const Track& track,
               Conditions& conditions, random_missions::Random& random);

}  // namespace glider::random_proofs
