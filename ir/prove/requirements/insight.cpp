// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is known of a mission without a search over traces: bounds on time, depth and surfacing,
// from the clocks and the commands alone. In: a ProofContext, with power cuts or without, and its
// end bound; out: whether a requirement is proved, and what proved requirements add to it. The
// order matters only for how much is proved, never for whether it is right. Used by `requirements`,
// for each requirement before Spacer is asked, and again after others have been proved.

#include "ir/prove/requirements/insight.h"

#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/surfacing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace glider::ir::prove {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

}  // namespace

Insight::Insight(const ProofContext& proof_context, const EndBound& end)
    : context_(end.by ? proof_context.endingBy(std::ranges::max(end.left_by)) : proof_context),
      end_(end),
      by_state_(boundsOfStates(context_, end)),
      bounds_(ofPossibleStates(by_state_, end)),
      moment_(context_, bounds_),
      ended_by_(end.by ? std::ranges::max(end.left_by) : kNoLimit),
      surfaces_every_(kNoLimit) {}

const std::vector<StateBounds>& Insight::byState() {
  if (!std::exchange(knows_climbs_, true)) {
    const std::vector<double> climbs = climbTimes(context_);
    for (size_t i = 0; i < by_state_.size(); ++i) {
      by_state_[i].climbs = std::isfinite(climbs[i]);
    }
  }
  return by_state_;
}

bool Insight::proves(const Requirement& requirement, unsigned effort, Budget& budget) {
  switch (requirement.kind) {
    case RequirementKind::Always:
      return moment_.neverFalse(requirement.condition, effort, budget);
    case RequirementKind::ExitWithin:
      return ended_by_ <= requirement.seconds;
    case RequirementKind::SurfacesEvery:
      return std::min(ended_by_, surfaces_every_) <= requirement.seconds ||
             submersion() <= requirement.seconds;
    case RequirementKind::NeverAfter:
    case RequirementKind::StackAtMost:
    case RequirementKind::Reach:
      break;
  }
  return false;
}

void Insight::know(const Requirement& requirement) {
  switch (requirement.kind) {
    case RequirementKind::Always:
      if (requirement.geofences.empty()) {
        moment_.know(requirement.condition);
      }
      break;
    case RequirementKind::ExitWithin:
      ended_by_ = std::min(ended_by_, requirement.seconds);
      break;
    case RequirementKind::SurfacesEvery:
      surfaces_every_ = std::min(surfaces_every_, requirement.seconds);
      break;
    case RequirementKind::NeverAfter:
    case RequirementKind::StackAtMost:
    case RequirementKind::Reach:
      break;
  }
}

double Insight::submersion() {
  if (!submersion_) {
    submersion_ = longestSubmersion(context_, end_, kLongestMission).value_or(kNoLimit);
  }
  return *submersion_;
}

}  // namespace glider::ir::prove
