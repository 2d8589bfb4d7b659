// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/prove/prove.h"
#include "support/result.h"

#include <map>
#include <string>

namespace glider::compiler {

/// Proves what can be proved about a mission; reports GL31xx, and returns lines for the report.
/// Where a command is refused (GL3104, GL3105), what its flights may do is not reported.
ir::prove::Findings prove(const Checked& checked, ir::prove::Options options,
                          support::DiagnosticEngine& diagnostics);

/// The cases that GL3101 or GL3103 reports as never firing, each with whether earlier cases hide
/// it.
std::map<ir::CasePlace, bool> casesThatNeverFire(const Checked& checked);

/// Everything that a proof is about: the mission and its platform file. As support::readFile.
support::Result<std::string> proofSubject(const Checked& checked);

/// The prover's questions for any solver (ir/prove/chc.h).
std::string chcText(const Checked& checked);

}  // namespace glider::compiler
