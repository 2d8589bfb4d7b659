// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "support/diagnostics/engine.h"
#include "support/source_manager.h"

#include <optional>

namespace glider::ir {

/// The mission whose text form (see `print`) is file `file` of `sources`, with ranges in that text;
/// or nothing, and at least one error GL18xx in `diagnostics`. Accepts any bytes: memory and time
/// grow only with the text's length. What it returns passes `validate`.
std::optional<Mission> read(const support::SourceManager& sources, uint32_t file,
                            support::DiagnosticEngine& diagnostics);

}  // namespace glider::ir
