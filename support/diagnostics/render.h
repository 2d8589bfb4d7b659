// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/source_manager.h"

#include <string>

namespace glider::support {

/// The text a pilot reads: `file:line:col: error: message [GL2003 slug]`, the source line, a caret
/// line, hint and notes; one block per diagnostic, in source order. `colour` adds ANSI colours.
std::string render(const DiagnosticEngine& diagnostics, const SourceManager& sources, bool colour);

}  // namespace glider::support
