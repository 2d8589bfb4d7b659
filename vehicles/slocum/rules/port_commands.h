// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "support/diagnostics/engine.h"

namespace glider::slocum::rules {

/// Reports each command of `mission` that a vehicle without hookbeh cannot be given by its port for
/// a backseat driver, with the nearest that it can (GL4015).
void checkPortCommands(const ir::Mission& mission, support::DiagnosticEngine& diagnostics);

}  // namespace glider::slocum::rules
