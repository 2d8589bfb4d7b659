// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir::prove {

/// Every order that a profile or route may give: of its entry and its cases, both sides of every
/// `if`, in the order of the text. They stand in `mission`, which outlives them.
std::vector<const Statement*> ordersOf(const Mission& mission, const Activity& activity);

/// Whether a command is about depth and pitch; else it is about the heading.
bool isVertical(Command command);

}  // namespace glider::ir::prove
