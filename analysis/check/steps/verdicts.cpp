// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "analysis/closed_loop.h"
#include "support/one_line.h"

#include <string>
#include <utility>

namespace glider::analysis::check {
namespace {

using report::Remark;
using support::Result;

report::FlightSearch told(const ClosedLoop& search) {
  report::FlightSearch all;
  all.flights = search.flights;
  if (search.breaking) {
    all.scenario = search.breaking->scenario;
    all.seed = search.breaking->seed;
    all.when_s = search.breaking->when;
  }
  return all;
}

/// With `--report` a flight is searched for that violates a refuted requirement.
Result<report::JudgedRequirement> judged(Run& run, const ir::prove::RequirementVerdict& verdict) {
  const auto range = run.mission().requirements[verdict.requirement].range;
  report::JudgedRequirement judged{range,
                                   support::onOneLine(run.checked().sources().text(range)),
                                   ir::prove::word(verdict.verdict),
                                   std::nullopt,
                                   ir::prove::premisesOf(verdict, run.mission()),
                                   verdict.reason};
  if (run.options.report && verdict.verdict == ir::prove::Verdict::Refuted && verdict.run) {
    run.observer.at("looking for a flight that violates: " + judged.text);
    const auto search = searchClosedLoop(run.optimised(), verdict);
    if (!search) {
      return std::unexpected(search.error());
    }
    judged.closed_loop = told(*search);
  }
  return judged;
}

/// Whether a verdict is about the flight, and not about the structure of the mission alone.
bool isAboutTheFlight(ir::RequirementKind kind) {
  return kind == ir::RequirementKind::Always || kind == ir::RequirementKind::ExitWithin ||
         kind == ir::RequirementKind::SurfacesEvery;
}

}  // namespace

/// Puts the prover's findings into those of the mission.
Result<void> verdicts(Run& run) {
  for (const ir::prove::ReportLine& line : run.file.proved.lines) {
    run.file.found.remarks.push_back(
        {line.range, line.text, line.about_end ? Remark::Subject::End : Remark::Subject::Other});
  }
  for (const ir::prove::RequirementVerdict& verdict : run.file.proved.requirements) {
    auto one = judged(run, verdict);
    if (!one) {
      return std::unexpected(one.error());
    }
    const auto kind = run.mission().requirements[verdict.requirement].kind;
    if (verdict.verdict == ir::prove::Verdict::Proved && isAboutTheFlight(kind)) {
      const std::string& with = run.file.vehicle_premise;
      one->premise += (one->premise.empty() || with.empty() ? "" : "; ") + with;
    }
    run.file.found.requirements.push_back(std::move(*one));
  }
  return {};
}

}  // namespace glider::analysis::check
