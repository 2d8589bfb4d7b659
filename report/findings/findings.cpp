// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/findings/findings.h"

#include <algorithm>

namespace glider::report {

bool CheckedMission::ok() const {
  return !failure && std::ranges::none_of(diagnostics, [](const support::Diagnostic& d) {
    return d.severity == support::Severity::Error;
  });
}

}  // namespace glider::report
