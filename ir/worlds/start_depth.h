// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

namespace glider::ir {

/// The greatest reading of the depth with which `mission` may begin, m (rule P6 of ir/README.md):
/// so much less than the depth that proofs assume as a reading may be wrong.
double startReading(const Mission& mission, const platforms::Platform& platform);

}  // namespace glider::ir
