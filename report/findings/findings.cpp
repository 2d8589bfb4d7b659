// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/findings/findings.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::report {

bool CheckedMission::ok() const {
  return !failure && std::ranges::none_of(diagnostics, [](const support::Diagnostic& d) {
    return d.severity == support::Severity::Error;
  });
}

std::string searchInWords(const FlightSearch& search) {
  if (search.flights == 0) {
    return "not flown: the mission needs code in C, or the simulator cannot fly its vehicle";
  }
  return search.scenario.empty()
             ? fmt::format("none of {} simulated flights violates it", search.flights)
             : fmt::format(
                   "a simulated flight violates it too: scenario {}, --seed {}, at {:.6g} s",
                   search.scenario, search.seed, search.when_s);
}

}  // namespace glider::report
