// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "frontend/symbols.h"
#include "support/result.h"

#include <memory>

namespace glider::compiler {

/// The names of a mission, whether or not it has errors.
struct Symbols {
  std::shared_ptr<const support::SourceManager> sources;  ///< of all ranges in it; 0: the mission
  frontend::SymbolTable table;
};

/// The names of what was compiled, found when this is called: from Compilation::parsed, or if there
/// is none, from what can be read of the text and its imports. A file in the IR's text form, bad
/// platform data and a missing library are a Failure.
support::Result<Symbols> symbolsOf(const Compilation& compilation);

}  // namespace glider::compiler
