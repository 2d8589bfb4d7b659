// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/proof_context.h"

#include <string>
#include <vector>

/// Whether a mission stays in its areas, or out of them: geometry, without a solver.
///
/// Take the convex hull of the waypoints and of the place where control was given. A vehicle that
/// only steers to waypoints gets no farther from this hull than the current sets it. From its
/// estimated position it goes straight to a point of the hull, so its distance from the hull does
/// not grow; and each fix moves its estimated position by what the current has set it since the fix
/// before. Turning adds `steering_error_m`.
///
/// - It may be at the surface at any time: a yo comes up, a dive may be late, a guard of hookbeh
///   makes it climb. So it is set at the greater of `drift_m_s` and `surface_drift_m_s` all the
///   time.
/// - While it steers by a heading, or by none, it may also go `through_water_m_s` in any direction.
///   A mission that does so at any time is assumed to do so all the time.
/// - The same holds for every vehicle while the SBC has no power, as it then goes straight on, or
///   up. All outages together are assumed to last no longer than `resume within`.
///
/// So the margin grows with the time by which the mission has ended (end_bound.h).
namespace glider::ir::prove {

struct GeofenceVerdict {
  bool proved = false;  ///< the geofences are kept
  double margin_m = 0;  ///< if proved: how far from the edges control must be given
  /// How close to one of the waypoints, m; 0: the area to stay in determines it.
  double start_within_m = 0;
  std::string reason = {};  ///< why they are not known to be kept
  /// The mission assumes where control is given, which is enough.
  bool start_assumed = false;
};

/// The verdict on `geofences` for the whole flight. If the mission assumes an area in which control
/// is given, its corners are taken like waypoints. Otherwise the verdict assumes that control is
/// given on the right side of the edges by the margin and within `start_within_m`, and that the
/// hull of that place and the waypoints is on the right side. (A way from farther off would bend
/// more on the map.) Distances are those of area_map.h, rounded down. In all, the SBC is without
/// power for `dark_s` seconds at most.
GeofenceVerdict judgeGeofences(const std::vector<Geofence>& geofences,
                               const ProofContext& proof_context, double dark_s, Ending& ending);

}  // namespace glider::ir::prove
