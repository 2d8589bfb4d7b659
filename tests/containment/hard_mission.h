// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::containment {

/// The mission of `seed`: valid and free of verification errors, weighted to what is hard to
/// prove right: states that swap their parameters, `if` on unknown conditions, commands in every
/// list, durations and ranges at their ends, calls and returns, `always` above all, long outages.
ir::Mission hardMission(uint64_t seed);

}  // namespace glider::containment
