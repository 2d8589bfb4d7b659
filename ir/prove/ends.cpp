// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/end_bound.h"
#include "ir/prove/passes.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::ir::prove {
namespace {

/// No flight is meant to be so short; the vehicle has not even left the surface.
constexpr double kAtOnce = 60;

/// A year: no mission is meant to be as long.
constexpr double kLongest = 365 * 86400.0;

/// "2 h 1 min 12 s", rounded up.
std::string durationOf(double seconds) {
  const auto whole = static_cast<int64_t>(std::ceil(seconds));
  std::string text = whole >= 3600 ? fmt::format("{} h ", whole / 3600) : "";
  text += whole >= 60 ? fmt::format("{} min ", whole / 60 % 60) : "";
  return text + fmt::format("{} s", whole % 60);
}

}  // namespace

void passes::ends(Proof& proof) {
  // Only what ends soon is looked for unless there is a report: that is quick.
  const auto end = endsBy(proof.ground, proof.options.report ? kLongest : kAtOnce);
  if (!end) {
    return;
  }
  if (*end <= kAtOnce) {
    proof.diagnostics.report(support::DiagnosticId::endsAtOnce,
                             proof.ground.mission.states.front().range, durationOf(*end));
  } else {
    proof.findings.lines.push_back(
        {{}, fmt::format("the mission has ended after {} at the latest", durationOf(*end))});
  }
}

}  // namespace glider::ir::prove
