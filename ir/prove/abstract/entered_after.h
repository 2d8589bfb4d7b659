// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::ir::prove {

/// Whether some chain of transitions enters `state`, by goto or call, after `after` was current,
/// with any values of the guards. False is a proof; true proves nothing.
bool mayEnterAfter(const Mission& mission, StateId state, StateId after);

}  // namespace glider::ir::prove
