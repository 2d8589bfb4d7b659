// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `ends`: by when the mission has ended. In: the end bound (abstract/end_bound.h), with
// and without power cuts. Out: a warning for a mission that always ends within a minute (GL3109),
// otherwise lines of the report. A bound is certain. That none is found says nothing about flights,
// so the line says what was not found, and why.

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/end_depends_on.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

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

/// "; its end may depend on readings of `lat`, `lon`".
std::string dependsOn(const ProofContext& proof_context, const std::vector<StateId>& states) {
  std::vector<std::string> names;
  for (const SensorId id : endDependsOn(proof_context, states)) {
    names.push_back(fmt::format("`{}`", proof_context.mission[id].name));
  }
  return names.empty()
             ? ""
             : fmt::format("; its end may depend on readings of {}", fmt::join(names, ", "));
}

/// Why there is no bound: what was not found, not what a flight does, which is not known.
/// `assumed`: how many of the mission's assumptions hold here.
std::string noBound(const ProofContext& proof_context, const EndBound& end, size_t assumed) {
  const Mission& m = proof_context.mission;
  const bool required = std::ranges::any_of(m.requirements, [](const Requirement& r) {
    return r.kind == RequirementKind::ExitWithin ||
           (r.kind == RequirementKind::Always && r.seconds > 0);
  });
  // A requirement may be proved in other ways, with everything that the mission assumes.
  const std::string none =
      fmt::format("{}{}",
                  required ? "adding up the times of its states gives no bound on the mission's "
                             "duration"
                           : "no bound on the mission's duration was found",
                  m.assumptions.size() <= assumed ? ""
                  : assumed == 0                  ? " without what it assumes"
                                                  : " without what else it assumes");
  const std::string verdict = required ? " (for `exit within` see its verdict)" : "";
  if (end.stays.valid()) {
    return fmt::format("{}, because none was found on the time in `{}`{}{}", none,
                       m[end.stays].name, dependsOn(proof_context, {end.stays}), verdict);
  }
  std::vector<std::string> loop;
  for (const StateId state : end.loop) {
    loop.push_back(fmt::format("`{}`", m[state].name));
  }
  return none +
         (loop.empty() ? ""
                       : fmt::format(", because none was found on how often it goes through {}",
                                     fmt::join(loop, ", "))) +
         dependsOn(proof_context, end.loop) + verdict;
}

/// What the mission assumes of outages; null: nothing.
const Assumption* assumedOutage(const Mission& m) {
  const auto found = std::ranges::find(m.assumptions, AssumptionKind::Outage, &Assumption::kind);
  return found == m.assumptions.end() ? nullptr : &*found;
}

/// The lines about a mission in which two ticks are at most as far apart as `proof_context` says.
std::vector<std::string> endLines(const ProofContext& proof_context, Ending& ending,
                                  size_t assumed) {
  std::vector<std::string> lines;
  const ProofContext powered = proof_context.withoutPowerCuts();
  const EndBound& undisturbed = ending.boundWithoutPowerCuts();
  const EndBound& end = ending.bound();
  if (end.by && undisturbed.by) {
    lines.push_back(
        fmt::format("the mission ends {}", latest(proof_context, *undisturbed.by, *end.by)));
  } else if (undisturbed.by) {
    lines.push_back(
        fmt::format("the mission ends after at most {}; with power cuts of the SBC of up to {}, no "
                    "bound was found",
                    durationOf(*undisturbed.by), durationOf(proof_context.tick_gap_s)));
  } else {
    lines.push_back(noBound(proof_context, undisturbed, assumed));
  }
  const EndBound soon = boundOf(powered, kLongestMission, Goal::ExitOrSurface);
  const EndBound home = boundOf(proof_context, kLongestMission, Goal::ExitOrSurface);
  // A promise to surface sooner has a verdict of its own.
  const bool promised =
      std::ranges::any_of(proof_context.mission.requirements, [&](const Requirement& requirement) {
        return requirement.kind == RequirementKind::SurfacesEvery &&
               requirement.seconds < soon.by.value_or(0);
      });
  if (soon.by && home.by && *soon.by > 0 && !promised && (!end.by || *home.by < *end.by)) {
    lines.push_back(fmt::format("counted from the start, it ends or first commands the surface {}",
                                latest(proof_context, *soon.by, *home.by)));
  }
  return lines;
}

/// What makes an end certain only then.
const char* withoutCuts(const ProofContext& proof_context) {
  return proof_context.tick_gap_s > proof_context.withoutPowerCuts().tick_gap_s
             ? ", unless the SBC is without power"
             : "";
}

/// Under what the mission assumes of outages: nothing is said of others.
void tellEnd(Proof& proof) {
  const Assumption* outage = assumedOutage(proof.proof_context.mission);
  ProofContext assumed = proof.proof_context;
  if (outage != nullptr) {
    assumed.tick_gap_s = std::max(assumed.platform.world.tick_gap_s,
                                  std::min(assumed.mission.resume_within_s, outage->limit));
  }
  Ending under(assumed);
  const bool differs = assumed.tick_gap_s < proof.proof_context.tick_gap_s;
  for (std::string& line : endLines(assumed, differs ? under : proof.ending, differs ? 1 : 0)) {
    const std::string premise = differs ? fmt::format("assuming `{}`, ", outage->words) : "";
    proof.findings.lines.push_back({{}, premise + std::move(line), true});
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
    proof.diagnostics.report(support::diagnostics::endsAtOnce,
                             proof.proof_context.mission.states.front().range,
                             durationOf(*end.by) + withoutCuts(proof.proof_context));
  } else if (report) {
    tellEnd(proof);
  }
}

}  // namespace glider::ir::prove
