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

/// Reads a mission or library file; every error in its text is reported (GL1xxx). Empty if its
/// structure could not be recognised. If every error could be corrected with certainty (such as `=`
/// for `==`), the file is still returned, so that `analyse` can report its other errors.
std::optional<ast::File> parse(const support::SourceManager& sources, uint32_t file,
                               support::DiagnosticEngine& diagnostics);

/// The parts of a file that parse, item by item, for tools that continue where `parse` gives up:
/// items with errors are left out. Reports nothing.
ast::File parseIntact(const support::SourceManager& sources, uint32_t file);

/// The inputs of a mission's analysis.
struct AnalysisInputs {
  const platforms::Platform& platform;    ///< the one that platformName() names
  std::vector<const ast::File*> library;  ///< parsed library files, the standard ones first
  const support::SourceManager& sources;  ///< holds the texts of the mission and the library
  size_t standard = 1;                    ///< how many of them are the standard library's
};

/// A value that the mission leaves to `glidercc plan`: a line `choose`.
struct OpenChoice {
  std::string name;
  ir::Type type;
  std::string unit;   ///< of its range, as written; empty: the SI unit, or none
  double lowest = 0;  ///< of its range, SI units
  double highest = 0;
  double step = 0;               ///< between the values that are tried; 0: the line names none
  support::SourceRange written;  ///< of its value; empty, and after its type: none is written
};

/// A part of the line `prefer`.
struct OpenObjective {
  ast::Aim aim = ast::Aim::Endurance;
  double value = 0;  ///< with the choices as they are; SI units; of all but endurance
  ir::Type type;
  support::SourceRange range;  ///< of its expression
};

/// What the mission leaves open.
struct LeftOpen {
  std::vector<OpenChoice> choices;
  std::vector<OpenObjective> objectives;  ///< the most important first; none: endurance
};

/// What a text says beside the mission that is made of it.
struct BesideMission {
  ir::CInterface in_c;  ///< what it declares in C
  LeftOpen open;
};

/// The platform that `mission` names: platforms::kDefaultPlatform if it names none.
std::string platformName(const ast::File& mission);

/// Resolves names, types and units (GL2xxx) and lowers the mission to IR. Empty if there was an
/// error, now or in `parse`: then `diagnostics` has errors. `beside`, unless null, receives what
/// else the text says; what is left open also if there are errors elsewhere.
std::optional<ir::Mission> analyse(const ast::File& mission, const AnalysisInputs& inputs,
                                   support::DiagnosticEngine& diagnostics,
                                   BesideMission* beside = nullptr);

}  // namespace glider::frontend
