// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/certificate.h"
#include "ir/worlds/worlds.h"
#include "platforms/load/platform.h"

#include <span>
#include <string>
#include <vector>

namespace glider::ir::certify {

/// A script of SMT-LIB 2 (declare-const, define-fun, assert, push, pop, check-sat). It shows what
/// it should only if every check-sat is answered `unsat` and there is no error.
struct Script {
  std::string text;
  /// What each check-sat shows, in their order.
  std::vector<std::string> obligations;
};

/// What must be shown so that `invariants`, one for each configuration, hold in every flight and
/// the requirement with them: a script for the start, then one for each invariant. They show that
/// the start satisfies the invariant of where it leads; that an invariant, time that passes and a
/// tick imply the invariant of where the tick leads (a configuration that is not listed must be
/// unreachable); and that no start and no tick violates the requirement. The kinds Always (without
/// geofences), ExitWithin, NeverAfter, SurfacesEvery and StackAtMost have such proofs.
std::vector<Script> obligationsOf(const Mission& mission, const platforms::Platform& platform,
                                  const Requirement& requirement,
                                  std::span<const Invariant> invariants, double longest_gap_s);

/// The same for the requirement with that number of a mission that assumes something: under the
/// assumptions with these numbers, and no others.
std::vector<Script> obligationsUnder(const WidestWorld& widest, uint32_t requirement,
                                     std::span<const uint32_t> assumptions,
                                     std::span<const Invariant> invariants);

/// The longest time between two ticks. Without a power cut it is the platform's `tick_gap_s`; after
/// one, the mission continues only if at most `resume within` has passed since the newest
/// checkpoint (README P2, P3; docs/verification.md, power cuts), whichever is longer.
double longestGap(const Mission& mission, const platforms::Platform& platform);

}  // namespace glider::ir::certify
