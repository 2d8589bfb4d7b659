// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/geometry/geofences.h"

#include "ir/prove/requirements/strategy.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::ir::prove {
namespace {

/// How long the SBC is without power in a flight, s: an assumption only limits each outage, but one
/// that leaves none limits all.
double darkTogether(const StrategyContext& context) {
  const double resume = context.mission.resume_within_s;
  const bool some = resume > context.proof.proof_context.platform.world.tick_gap_s;
  return some && context.bare != nullptr ? context.bare->mission.resume_within_s : resume;
}

GeofenceVerdict verdictOn(const Requirement& requirement, const StrategyContext& context) {
  return judgeGeofences(requirement.geofences, context.proof.proof_context, darkTogether(context),
                        context.proof.ending);
}

/// What the pilot must see to; empty: nothing.
std::string premiseOf(const GeofenceVerdict& proved) {
  if (proved.start_assumed) {
    return "";
  }
  const std::string near =
      proved.start_within_m > 0
          ? fmt::format(" and within {:g} km of a waypoint", proved.start_within_m / 1000)
          : "";
  return fmt::format(
      "assuming that control is given on the right side of each edge, at least {0:.0f} m from "
      "it{1}, and that everything between there and the waypoints is also {0:.0f} m from the edge",
      std::ceil(proved.margin_m), near);
}

/// `always inside(…)`: the hull of the waypoints is far enough from each edge.
class GeofenceGeometry final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return !requirement.geofences.empty();
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    const GeofenceVerdict found = verdictOn(attempt.requirement, context);
    if (found.proved) {
      RequirementVerdict proved{attempt.number, Verdict::Proved, std::nullopt, premiseOf(found)};
      proved.start_margin_m = found.start_assumed ? 0 : found.margin_m;
      return proved;
    }
    attempt.reason = found.reason;
    return std::nullopt;
  }

  RepeatedProof provesAgain(const RequirementVerdict& was,
                            StrategyContext& context) const override {
    const Requirement& requirement = context.mission.requirements[was.requirement];
    const GeofenceVerdict found = verdictOn(requirement, context);
    return found.proved && premiseOf(found) == was.premise ? provedAgain(requirement, context)
                                                           : RepeatedProof();
  }

  [[nodiscard]] std::optional<Evidence> evidence(const Requirement&, bool,
                                                 StrategyContext&) const override {
    return Evidence{Method::Geometry, {}};
  }

  [[nodiscard]] bool mayRestOn(const Assumption& assumption, const Requirement&) const override {
    return assumption.kind != AssumptionKind::StartDepth &&
           assumption.kind != AssumptionKind::Always;
  }
};

}  // namespace

const Strategy& strategy::geofences() {
  static const GeofenceGeometry kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
