// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/check/check.h"
#include "driver/output/check_progress.h"

#include <string>

namespace glider::driver {

using analysis::CheckedFile;
using analysis::CheckOptions;

/// Shows what a check does on the last line of the terminal, and the errors in a scenario.
class ShownOnTerminal final : public analysis::CheckObserver {
 public:
  ShownOnTerminal(const std::string& mission, const CheckOptions& options)
      : progress_(mission, options.timeout_s) {}

  void at(const std::string& work) override { progress_.at(work); }
  void show(const support::DiagnosticEngine& diagnostics,
            const support::SourceManager& sources) override;

 private:
  CheckProgress progress_;
};

/// analysis::checkMission with its progress on the last line of the terminal; errors in a scenario
/// are printed.
CheckedFile checkOnTerminal(const std::string& path, const CheckOptions& options);
/// The same for a mission that is compiled already.
CheckedFile checkOnTerminal(const std::string& name, compiler::Compilation compiled,
                            const CheckOptions& options);

}  // namespace glider::driver
