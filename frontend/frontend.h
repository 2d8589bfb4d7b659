// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/ast/print.h"
#include "ir/core/c_symbols.h"
#include "ir/core/mission.h"
#include "platforms/load/platform.h"
#include "support/diagnostics/engine.h"
#include "support/source_manager.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::frontend {

/// Reads a mission or library file; every mistake in its text is reported (GL1xxx). Empty if its
/// structure could not be made out; a file whose every mistake was plain enough to be read past
/// (`=` for `==`) is still given, so that `analyse` can report what else is wrong with it.
std::optional<ast::File> parse(const support::SourceManager& sources, uint32_t file,
                               support::DiagnosticEngine& diagnostics);

/// What of a file parses item by item, for tools that go on where `parse` gives up: items with
/// mistakes are left out. Reports nothing.
ast::File parseIntact(const support::SourceManager& sources, uint32_t file);

/// What a mission is compiled against.
struct AnalysisInputs {
  const platforms::Platform& platform;    ///< the one that platformName() names
  std::vector<const ast::File*> library;  ///< parsed library files, the standard one first
  const support::SourceManager& sources;  ///< holds the texts of the mission and the library
};

/// The platform that `mission` asks for: "slocum" if it does not say.
std::string platformName(const ast::File& mission);

/// Gives names, types and units their meaning (GL2xxx) and lowers the mission to IR. Empty if
/// anything was wrong with it, now or in `parse`: then `diagnostics` has errors. `in_c`, if wanted,
/// gets what it declares in C.
std::optional<ir::Mission> analyse(const ast::File& mission, const AnalysisInputs& inputs,
                                   support::DiagnosticEngine& diagnostics,
                                   ir::CInterface* in_c = nullptr);

}  // namespace glider::frontend
