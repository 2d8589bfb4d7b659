// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"
#include "support/result.h"

#include <string>

namespace glider::driver {

/// The page of a diagnostic, Markdown: `# GL2007: title` and its text. GL9001.
support::Result<std::string> explainPage(support::DiagnosticId id);

}  // namespace glider::driver
