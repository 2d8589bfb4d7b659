// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>

namespace glider::ir::prove {

/// Of `whenever A then B within T`, and of `when`: two states of which B is on the stack whenever A
/// is. B then counts at once, so that the promise holds in any flight.
struct StandingAnswer {
  StateId cause;
  StateId response;
};

/// None if the requirement is not such a promise. Certain: from the call configurations alone.
std::optional<StandingAnswer> standingAnswer(const Mission& mission,
                                             const Requirement& requirement);

}  // namespace glider::ir::prove
