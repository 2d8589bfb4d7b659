// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/duration_text.h"
#include "ir/prove/end_bound.h"
#include "ir/prove/passes.h"

#include <fmt/format.h>

namespace glider::ir::prove {
namespace {

/// No flight is meant to be so short; the vehicle has not even left the surface.
constexpr double kAtOnce = 60;

void tellEnd(Proof& proof, const EndBound& end) {
  const auto tell = [&](std::string text) {
    proof.findings.lines.push_back({{}, std::move(text)});
  };
  if (end.by) {
    tell(fmt::format("the mission has ended after {} at the latest", durationOf(*end.by)));
  } else if (end.stays.valid()) {
    tell(fmt::format("no clock alone ends the mission: it may stay in `{}`",
                     proof.ground.mission[end.stays].name));
  } else {
    tell("no bound for the mission's end is known");
  }
  const EndBound home = boundOf(proof.ground, kLongestMission, Goal::ExitOrSurface);
  if (home.by && (!end.by || *home.by < *end.by)) {
    tell(fmt::format("it has ended, or ordered the surface, after {} at the latest",
                     durationOf(*home.by)));
  }
}

}  // namespace

void passes::ends(Proof& proof) {
  // Only what ends soon is looked for unless there is a report: that is quick.
  const bool report = proof.options.report;
  const EndBound end = report ? proof.ending.bound() : boundOf(proof.ground, kAtOnce, Goal::Exit);
  if (end.by && *end.by <= kAtOnce) {
    proof.diagnostics.report(support::DiagnosticId::endsAtOnce,
                             proof.ground.mission.states.front().range, durationOf(*end.by));
  } else if (report) {
    tellEnd(proof, end);
  }
}

}  // namespace glider::ir::prove
