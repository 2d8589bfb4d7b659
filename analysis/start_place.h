// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "support/diagnostics/engine.h"

#include <string>

namespace glider::analysis {

/// Where a flight starts.
struct StartPlace {
  std::string name;  ///< "scenario `default`"
  ir::Position at;
};

/// Reports a start outside the area that the mission assumes (GL3126).
void checkStart(const compiler::Checked& mission, const StartPlace& start,
                support::DiagnosticEngine& diagnostics);

}  // namespace glider::analysis
