// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/cadence.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// m; above this depth m_depth may be clipped: it is never negative, and repeats its zero.
constexpr double kClippedM = 1;
/// s; over this time a new cadence is learned. A long gap counts by its length, because it is in
/// the long gaps that the vehicle sinks unseen.
constexpr double kLearnsSecs = 120;
/// s; a longer gap is a fault and not a cadence.
constexpr double kLongestGapSecs = 32;
/// The first gaps teach nothing: a few readings do not show a cadence.
constexpr double kFew = 3;

}  // namespace

bool Cadence::isKnown() const {
  return learned_ > kFew;
}

void Cadence::observe(double depth_m, double step_s) {
  since_s_ = is_new_ ? step_s : since_s_ + step_s;
  is_new_ = isFinite(depth_m) && depth_m != last_m_;
  if (!is_new_) {
    return;
  }
  if (last_m_ > kClippedM) {
    learn(atMost(since_s_, kLongestGapSecs));
  }
  last_m_ = depth_m;
}

void Cadence::learn(double gap_s) {
  learned_ += 1;
  if (isKnown()) {
    usual_s_ += (gap_s - usual_s_) * atLeast(gap_s / kLearnsSecs, 1 / (learned_ - kFew));
  }
}

}  // namespace glider::hooks
