// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::ir {

/// Leaves only what flies: drops the requirements, and the sensors that only they read.
void dropRequirements(Mission& mission);

}  // namespace glider::ir
