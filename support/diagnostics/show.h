// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/source_manager.h"

#include <functional>

namespace glider::support {

/// Shows a pilot the errors found while reading a file. The code that reads the file does not know
/// where they are shown; an empty function shows nothing.
using ShowDiagnostics = std::function<void(const DiagnosticEngine&, const SourceManager&)>;

}  // namespace glider::support
