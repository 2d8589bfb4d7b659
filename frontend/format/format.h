// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/source_manager.h"

#include <cstdint>
#include <optional>
#include <string>

namespace glider::frontend {

/// The canonical text of a mission or library file: the same words and comments in the same order,
/// with a new layout. Formatting the result changes nothing. Empty if the text has syntax errors,
/// which are reported.
///
/// The layout: indents of two spaces; a blank line around states, behaviours and `always`, and
/// wherever the pilot left one or more; lines of at most 100 columns where commas and operators
/// allow it; similar parts of neighbouring lines are aligned. A `do … end` or `if … end` that was
/// written on one line stays there if it is simple and fits; a list whose first item was written on
/// the line after its bracket has one item per line.
std::optional<std::string> format(const support::SourceManager& sources, uint32_t file,
                                  support::DiagnosticEngine& diagnostics);

}  // namespace glider::frontend
