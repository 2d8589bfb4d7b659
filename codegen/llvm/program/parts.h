// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/lower/lower_mission.h"

#include <vector>

namespace glider::codegen {

/// Parts of about the same work, for as many threads; the first has the head. How many depends on
/// the mission alone, so that every machine makes the same program of it.
std::vector<MissionPart> partsOf(const ir::Mission& mission);

}  // namespace glider::codegen
