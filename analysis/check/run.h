// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/check/check.h"
#include "simulator/scenario/scenario.h"
#include "support/result.h"

#include <optional>
#include <string>

namespace glider::analysis::check {

/// A check of a mission without errors in its text, and what its steps have found so far.
class Run {
 public:
  Run(const CheckOptions& with, CheckObserver& told, CheckedFile& of)
      : options(with), observer(told), file(of) {}

  const CheckOptions& options;
  CheckObserver& observer;
  CheckedFile& file;  ///< has a compilation, which is `checked`

  /// The scenario that is named, or the usual one; empty if that cannot be loaded: then less is
  /// checked.
  std::optional<simulator::Scenario> scenario;
  ir::prove::Options asked;  ///< of the prover

  [[nodiscard]] const compiler::Checked& checked() const { return *file.compilation->checked; }
  [[nodiscard]] const ir::Mission& mission() const { return checked().mission(); }
  [[nodiscard]] const ir::Worlds& worlds() const { return checked().worlds; }
  /// The vehicle as its makers describe it, not as the mission assumes it to be.
  [[nodiscard]] const platforms::Platform& platform() const { return worlds().widest.platform; }
  [[nodiscard]] support::DiagnosticEngine& diagnostics() const {
    return file.compilation->diagnostics;
  }
  /// The mission as it is built; made once.
  const compiler::Optimised& optimised();
  void remark(std::string line, report::Remark::Subject subject = {});

 private:
  std::optional<compiler::Optimised> optimised_;
};

#define STEP(name, when) support::Result<void> name(Run& run);
#include "analysis/check/check_steps.def"
#undef STEP

}  // namespace glider::analysis::check
