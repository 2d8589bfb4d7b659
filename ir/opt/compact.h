// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::ir::opt {

/// Drops the expressions, blocks and temporals that nothing uses any more, and renumbers the rest
/// in their order. Variables stay.
void compact(Mission& mission);

}  // namespace glider::ir::opt
