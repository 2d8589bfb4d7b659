// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::ir {

/// Leaves what flies: without the requirements, and without the sensors that only they read.
void dropRequirements(Mission& mission);

}  // namespace glider::ir
