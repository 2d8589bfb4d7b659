// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/symbolic_state.h"
#include "support/diagnostics/engine.h"

#include <vector>

namespace glider::ir::prove {

/// Adds notes that say which facts of sensors and variables a proof needed, each once.
void noteReasons(support::DiagnosticBuilder& report, const Mission& mission,
                 const std::vector<Fact>& facts, support::SourceRange where);

}  // namespace glider::ir::prove
