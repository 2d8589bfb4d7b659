// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/lower/lower_mission.h"

#include <vector>

namespace glider::codegen {

/// Parts with about the same work, for as many threads; the first has the head. Their number
/// depends only on the mission, so that every machine makes the same program from it.
std::vector<MissionPart> partsOf(const ir::Mission& mission);

}  // namespace glider::codegen
