// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/check_on_terminal.h"

#include "driver/terminal.h"

#include <utility>

namespace glider::driver {

void ShownOnTerminal::show(const support::DiagnosticEngine& diagnostics,
                           const support::SourceManager& sources) {
  progress_.clear();
  reportDiagnostics(diagnostics, sources);
}

CheckedFile checkOnTerminal(const std::string& path, const CheckOptions& options) {
  ShownOnTerminal observer(path, options);
  return analysis::checkMission(path, options, observer);
}

CheckedFile checkOnTerminal(const std::string& name, compiler::Compilation compiled,
                            const CheckOptions& options) {
  ShownOnTerminal observer(name, options);
  return analysis::checkCompilation(name, std::move(compiled), options, observer);
}

}  // namespace glider::driver
