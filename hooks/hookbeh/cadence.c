// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/cadence.h"

#include "hooks/protocol/numbers.h"

/// m; above this depth m_depth may be clipped: it is never negative, and repeats its zero.
static const double kClippedM = 1;
/// s; over this time a new cadence is learned. A long gap counts by its length, because it is in
/// the long gaps that the vehicle sinks unseen.
static const double kLearnsSecs = 120;
/// s; a longer gap is a fault and not a cadence.
static const double kLongestGapSecs = 32;
/// The first gaps teach nothing: a few readings do not show a cadence.
static const double kFew = 3;

void hookCadenceInit(HookCadence* cadence) {
  cadence->last_m = cadence->since_s = hookUnknown();
  cadence->usual_s = 4;
  cadence->learned = 0;
  cadence->is_new = false;
}

bool hookCadenceIsKnown(const HookCadence* cadence) {
  return cadence->learned > kFew;
}

static void learnGap(HookCadence* cadence, double gap_s) {
  cadence->learned += 1;
  if (hookCadenceIsKnown(cadence)) {
    cadence->usual_s += (gap_s - cadence->usual_s) *
                        hookAtLeast(gap_s / kLearnsSecs, 1 / (cadence->learned - kFew));
  }
}

void hookCadenceObserve(HookCadence* cadence, double depth_m, double step_s) {
  cadence->since_s = cadence->is_new ? step_s : cadence->since_s + step_s;
  cadence->is_new = hookIsFinite(depth_m) && depth_m != cadence->last_m;
  if (!cadence->is_new) {
    return;
  }
  if (cadence->last_m > kClippedM) {
    learnGap(cadence, hookAtMost(cadence->since_s, kLongestGapSecs));
  }
  cadence->last_m = depth_m;
}
