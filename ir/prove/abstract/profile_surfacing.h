// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/profile_modes.h"
#include "ir/prove/abstract/timer_guards.h"

#include <limits>
#include <vector>

namespace glider::ir::prove {

/// What is known of the time since the last tick at the surface as a state (or a mode of
/// its profile) becomes current, s.
struct Submerged {
  double longest = -1;  ///< negative: nothing, as no trace comes here
  /// With a timer: it is not set later than this after the last tick at the surface, as long as the
  /// state is current.
  double ahead = 0;
  /// Of a state that only climbs: its climb began no later than this after that tick.
  double begun = std::numeric_limits<double>::infinity();
};

/// What is known while a profile is in a mode. Times begin when its state became current or the
/// vehicle was last at the surface, whichever was later.
struct ModeBound {
  Mode mode;
  /// It was in this mode already then; one that climbs has commanded the surface since then or
  /// before.
  bool from_start = false;
  double longest = 0;  ///< until it came into this mode; of one that climbs, until it began to, s
  double ahead = 0;    ///< the timer is not set later than this, s
  double timed = 0;    ///< after each tick but the first, this at most after the timer was set, s
  [[nodiscard]] bool climbs() const { return mode.command == Command::Surface; }
};

/// How a profile of the language comes to the surface by itself again and again: a variable holds
/// since when, and some time later it commands the surface.
///
/// Its modes are followed as SurfacingSearch follows states. In each that does not climb, a case is
/// certainly true some time after `since`. One that climbs brings the vehicle to the surface within
/// `climb_s`. A case that leads from there to another finds it at the surface if it waits for that
/// long after one of `waits`, which every case that begins the climb sets.
struct ProfileSurfacing {
  /// From the start of the times to any tick under water, s; infinite: not found, the rest is
  /// empty.
  double longest = std::numeric_limits<double>::infinity();
  VariableId since;
  std::vector<VariableId> waits;
  std::vector<VariableId> own;  ///< of Mode::truths
  double climb_s = 0;
  std::vector<ModeBound> modes;
};

/// That of `state`, from whose deepest place it climbs in `climb_s`.
ProfileSurfacing profileSurfacing(const ProofContext& proof_context, const TimerGuards& guards,
                                  StateId state, double climb_s);

}  // namespace glider::ir::prove
