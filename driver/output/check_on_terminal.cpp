// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/check_on_terminal.h"

#include "driver/output/check_progress.h"
#include "driver/terminal.h"

#include <utility>

namespace glider::driver {
namespace {

class ToTerminal final : public analysis::CheckObserver {
 public:
  ToTerminal(const std::string& mission, const CheckOptions& options)
      : progress_(mission, options.timeout_s) {}

  void at(const std::string& work) override { progress_.at(work); }
  void show(const support::DiagnosticEngine& diagnostics,
            const support::SourceManager& sources) override {
    progress_.clear();
    reportDiagnostics(diagnostics, sources);
  }

 private:
  CheckProgress progress_;
};

}  // namespace

CheckedFile checkOnTerminal(const std::string& path, const CheckOptions& options) {
  ToTerminal observer(path, options);
  return analysis::checkMission(path, options, observer);
}

CheckedFile checkOnTerminal(const std::string& name, compiler::Compilation compiled,
                            const CheckOptions& options) {
  ToTerminal observer(name, options);
  return analysis::checkCompilation(name, std::move(compiled), options, observer);
}

}  // namespace glider::driver
