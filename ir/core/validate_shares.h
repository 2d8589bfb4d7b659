// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/defects.h"
#include "ir/core/mission.h"

namespace glider::ir {

/// The part of `validate` for what a mission tells others and receives of them.
void validateShares(const Mission& mission, Defects& defects);

}  // namespace glider::ir
