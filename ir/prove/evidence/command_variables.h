// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir::prove {

/// For every variable, whether the depth of some command depends on it, also through the values
/// that other variables are set to.
std::vector<bool> commandVariables(const Mission& mission);

}  // namespace glider::ir::prove
