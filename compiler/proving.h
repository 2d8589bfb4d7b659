// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/prove/prove.h"

#include <map>

namespace glider::compiler {

/// Proves what can be proved of a mission; reports GL31xx, and gives lines for the report.
ir::prove::Findings prove(const Checked& checked, ir::prove::Options options,
                          support::DiagnosticEngine& diagnostics);

/// The cases of which GL3101 or GL3103 says that they never fire, and of each whether it is earlier
/// ones that hide it.
std::map<ir::CasePlace, bool> casesThatNeverFire(const Checked& checked);

}  // namespace glider::compiler
