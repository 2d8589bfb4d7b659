// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/profile_surfacing.h"
#include "ir/prove/context/control.h"

#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace glider::ir::prove {

/// The longest time, s, from a tick with the vehicle at the surface (or the start) to any tick
/// under water before the next such, in any trace; none if it may exceed `limit`, or is not found.
/// `end`: of `proof_context`.
///
/// It is the longest path through the states, without a solver. While a state is current the time
/// since the last such tick grows, at most until the state is left (stayOf). A state *climbs* if it
/// commands the surface whenever it becomes current, and no other depth while it is. From
///
///     command_delay_s + turn_s + (its greatest depth - surface_depth_m) / slowest_climb_m_s
///
/// after it became current on, every tick is one at the surface (ir/prove/encoding/world.h). So a
/// state that climbs adds no more than that, and a trace that leaves it later starts from 0. The
/// same holds for a case that can only be true on a tick at the surface: one whose guard needs a
/// reading of the depth that is further above than `depth_error_m` allows under water. Mission time
/// bounds all: the vehicle is at the surface when control is given.
///
/// A mission's own timer (timers.h) bounds it too: since the last tick at the surface no more time
/// has passed than since the timer was set, and from that tick to the setting.
///
/// So does a profile that comes to the surface by itself (profile_surfacing.h), while its state is
/// current.
///
/// Stacks are not followed at first, then they are, if there are not too many (SurfacingPlaces).
std::optional<double> longestSubmersion(const ProofContext& proof_context, const EndBound& end,
                                        double limit);

/// For each state: from this time after it became current on, every tick is at the surface (s);
/// infinite if the state does not only climb.
std::vector<double> climbTimes(const ProofContext& proof_context);

/// What longestSubmersion rests on, for one state.
struct Submersion {
  Submerged entered;  ///< by goto or call
  Submerged resumed;  ///< by return
  /// From this time after it became current on, every tick is at the surface; infinite if not.
  double climb = std::numeric_limits<double>::infinity();
  /// With a timer: after each tick that leaves the state current, but the one on which it became
  /// so, this at most after the timer was set, or at the surface; s.
  double timed = std::numeric_limits<double>::infinity();
  ProfileSurfacing profile = {};
};

struct Submersions {
  std::vector<Submersion> states;  ///< empty if no bound is found
  VariableId timer;                ///< invalid: none
  /// What it rests on if stacks were followed; empty: they were not. In one that is not listed no
  /// trace can be.
  std::map<certify::Configuration, Submersion> configurations;

  /// That of a configuration.
  [[nodiscard]] Submersion of(certify::Configuration at) const;
};

/// What longestSubmersion rests on.
Submersions submersionsOf(const ProofContext& proof_context, const EndBound& end);

}  // namespace glider::ir::prove
