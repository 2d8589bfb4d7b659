// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "support/diagnostics/engine.h"
#include "support/source_manager.h"

#include <deque>
#include <optional>

namespace glider::frontend {

/// Reads and parses the files that `file` imports, and those that they import, each once and after
/// those it imports itself. A name is looked up beside the file that imports it, whose path is its
/// name in `sources`; `.mission` may be omitted. Files that cannot be read, cycles, chains of more
/// than 8 files (GL2080 and after) and errors in the files' own text are reported where they are,
/// with the imports that led there. The result is then empty, because analysis would only report
/// the missing definitions.
std::optional<std::deque<ast::File>> loadImports(const ast::File& file,
                                                 support::SourceManager& sources,
                                                 support::DiagnosticEngine& diagnostics);

/// The same for tools that continue where `loadImports` gives up: the files that can be read, each
/// as parseIntact reads it. Reports nothing.
std::deque<ast::File> loadIntactImports(const ast::File& file, support::SourceManager& sources);

}  // namespace glider::frontend
