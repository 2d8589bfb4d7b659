// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/coverage.h"

#include "analysis/check/run.h"

#include <string>
#include <utility>

namespace glider::analysis::check {

/// Which cases and states no proof depends on.
support::Result<void> coverage(Run& run) {
  run.observer.at("looking for cases that no requirement depends on");
  const auto found = coverageOf(run.checked(), run.file.proved.requirements, run.asked);
  if (found) {
    if (std::string line = coverageLine(*found, run.checked()); !line.empty()) {
      run.remark(std::move(line));
    }
  }
  return {};
}

}  // namespace glider::analysis::check
