// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "slocum/mission_files/mission_file.h"
#include "support/diagnostics/engine.h"

namespace glider::simulator {

/// Reports what the simulator cannot fly in `mission`: unknown behaviours (GL5103), b_args (GL5104,
/// GL5106), values it does not model (GL5107), no behaviour at all (GL5108, at `place`). Warns
/// about what has no effect (GL5110, GL5111).
void checkSkeleton(const slocum::MissionFile& mission, support::SourceRange place,
                   support::DiagnosticEngine& diagnostics);

}  // namespace glider::simulator
