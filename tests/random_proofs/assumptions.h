// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/random_proofs/conditions.h"

namespace glider::random_proofs {

/// Adds one or two assumptions: about the start, the current, the range of a sensor, outages,
/// readings that come often enough, or a condition.
void addAssumptions(ir::Mission& mission, Conditions& conditions, random_missions::Random& random);

}  // namespace glider::random_proofs
