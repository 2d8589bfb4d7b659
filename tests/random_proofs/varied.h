// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

namespace glider::random_proofs {

/// The mission with what random ones seldom have, and proofs are often about: cases that are due
/// about as deep as the vehicle can just get, places near to each other, a state that surfaces.
ir::Mission varied(ir::Mission mission, const platforms::Platform& platform, uint64_t seed);

}  // namespace glider::random_proofs
