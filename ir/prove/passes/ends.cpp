// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/end_depends_on.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/catalogue.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace glider::ir::prove {
namespace {

/// A flight is not meant to be shorter than this: the vehicle has not even left the surface.
constexpr double kAtOnce = 60;

/// "after at most 42 min 0 s; with power cuts of the SBC of up to 5 min 0 s, after at most 48 min".
std::string latest(const ProofContext& proof_context, double undisturbed, double with_power_cuts) {
  const std::string text = fmt::format("after at most {}", durationOf(undisturbed));
  return with_power_cuts <= undisturbed
             ? text
             : fmt::format("{}; with power cuts of the SBC of up to {}, after at most {}", text,
                           durationOf(proof_context.tick_gap_s), durationOf(with_power_cuts));
}

/// "; its end depends on readings of `lat`, `lon`".
std::string dependsOn(const ProofContext& proof_context, StateId stays) {
  std::vector<std::string> names;
  for (const SensorId id : endDependsOn(proof_context, stays)) {
    names.push_back(fmt::format("`{}`", proof_context.mission[id].name));
  }
  return names.empty() ? ""
                       : fmt::format("; its end depends on readings of {}", fmt::join(names, ", "));
}

void tellEnd(Proof& proof, const EndBound& end) {
  const auto tell = [&](std::string text) {
    proof.findings.lines.push_back({{}, std::move(text), true});
  };
  const ProofContext powered = proof.proof_context.withoutPowerCuts();
  const EndBound& undisturbed = proof.ending.boundWithoutPowerCuts();
  if (end.by && undisturbed.by) {
    tell(fmt::format("the mission ends {}", latest(proof.proof_context, *undisturbed.by, *end.by)));
  } else if (undisturbed.by) {
    tell(
        fmt::format("the mission ends after at most {}; with power cuts of the SBC of up to {}, no "
                    "bound is known",
                    durationOf(*undisturbed.by), durationOf(proof.proof_context.tick_gap_s)));
  } else if (undisturbed.stays.valid()) {
    tell(fmt::format("no clock condition is sure to end the mission: it may stay in `{}`{}",
                     proof.proof_context.mission[undisturbed.stays].name,
                     dependsOn(proof.proof_context, undisturbed.stays)));
  } else {
    tell("no bound on the mission's duration is known" + dependsOn(proof.proof_context, {}));
  }
  const EndBound soon = boundOf(powered, kLongestMission, Goal::ExitOrSurface);
  const EndBound home = boundOf(proof.proof_context, kLongestMission, Goal::ExitOrSurface);
  if (soon.by && home.by && (!end.by || *home.by < *end.by)) {
    tell(fmt::format("it ends, or commands the surface, {}",
                     latest(proof.proof_context, *soon.by, *home.by)));
  }
}

}  // namespace

void passes::ends(Proof& proof) {
  // Without a report, only an early end is searched for: that is quick.
  const bool report = proof.options.report;
  const EndBound end = report
                           ? proof.ending.boundWithoutPowerCuts()
                           : boundOf(proof.proof_context.withoutPowerCuts(), kAtOnce, Goal::Exit);
  if (end.by && *end.by <= kAtOnce) {
    proof.diagnostics.report(support::DiagnosticId::endsAtOnce,
                             proof.proof_context.mission.states.front().range, durationOf(*end.by));
  } else if (report) {
    tellEnd(proof, proof.ending.bound());
  }
}

}  // namespace glider::ir::prove
