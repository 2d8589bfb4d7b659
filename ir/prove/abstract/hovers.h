// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/proof_context.h"

#include <vector>

namespace glider::ir::prove {

/// A stay at one depth under water, that may be as long as the clocks allow. What else ends a state
/// is taken not to happen, except for the depth: conditions on it, and `profiledone`, are those of
/// a vehicle that has arrived. The states that follow at the same depth count too.
struct LongHover {
  StateId state;       ///< where it begins
  double depth_m = 0;  ///< the depth that is commanded, or its upper bound
  double lasts_s = 0;  ///< at most, with a tick in each cycle; infinite: no bound is known
};

/// One for each state that stays at one depth, unless only others at that depth lead to it.
/// `end`: of `proof_context`.
std::vector<LongHover> longHovers(const ProofContext& proof_context, const EndBound& end);

/// Shallower than this a commanded depth is the surface (hooks/hookbeh), m.
inline constexpr double kSurfaceCommand_m = 1;

}  // namespace glider::ir::prove
