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
/// those it imports itself. A name is looked for beside the file that imports it, whose place is
/// its name in `sources`; `.mission` may be left out. Files that cannot be read, cycles, chains of
/// more than 8 files (GL2080 and after) and mistakes in the files' own text are reported where
/// they are, with the imports that led there; then the result is empty, as analysis would only miss
/// what they define.
std::optional<std::deque<ast::File>> loadImports(const ast::File& file,
                                                 support::SourceManager& sources,
                                                 support::DiagnosticEngine& diagnostics);

/// The same for tools that go on where `loadImports` gives up: the files that can be read, each as
/// parseIntact reads it. Reports nothing.
std::deque<ast::File> loadIntactImports(const ast::File& file, support::SourceManager& sources);

}  // namespace glider::frontend
