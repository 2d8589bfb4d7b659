// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/prove/falsification/rng.h"
#include "runtime/core/continuation.h"

#include <optional>

namespace glider::random_proofs {

/// The SBC has no power for some time, in which the vehicle may restart its own mission.
struct Restart {
  runtime::Continuation then = runtime::Continuation::GoesOn;  ///< by the rules of the runtime
  double outage_s = 0;
  /// What begins after it is another flight, for which nothing counts from before.
  bool another_flight = false;
};

/// Draws one, at about one tick in 30. Its length is often near `resume_within_s` of `mission`, or
/// near that of another flight. `finished`: the mission has ended.
std::optional<Restart> drawRestart(ir::prove::Rng& dice, const ir::Mission& mission, bool finished);

}  // namespace glider::random_proofs
