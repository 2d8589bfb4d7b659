// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/proof_context.h"

#include <string>
#include <vector>

/// Whether a mission keeps in its areas, or out of them: geometry, no solver.
///
/// A vehicle that only ever steers to waypoints gets no further from the convex hull of where it
/// was given control and of its waypoints than the current sets it: where it takes itself to be, it
/// goes straight for a point of the hull, so its distance from the hull does not grow; and each fix
/// moves where it takes itself to be by what the current has set it since the one before. Turning
/// adds `steering_error_m`.
///
/// - It may be at the surface at any time: a yo comes up, a dive may be late, a guard of hookbeh
///   brings it up. So it is set at the greater of `drift_m_s` and `surface_drift_m_s` all the time.
/// - While it steers by a heading, or by none, it may also go `through_water_m_s` anywhere. A
///   mission that does so at any time is taken to do so all the time.
/// - So may any other while the SBC is dark, as the vehicle then goes straight on, or up: for
///   `resume within`, which all its outages together are taken to last at most.
///
/// So the margin grows with the time by which the mission has ended (end_bound.h).
namespace glider::ir::prove {

struct GeofenceVerdict {
  bool proved = false;  ///< they are kept
  double margin_m = 0;  ///< so far from the edges control has to be given; of what is proved
  /// No farther from one of the waypoints, m; 0: an area to keep in says where.
  double start_within_m = 0;
  std::string reason;  ///< why they are not known to be kept
};

/// Of `geofences`, for the whole flight, given that control is given on the right side by the
/// margin, within `start_within_m`, and that the hull of that place and the waypoints is. (A way
/// from farther off would bend more on the map.) Distances: of area_map.h, rounded down.
GeofenceVerdict judgeGeofences(const std::vector<Geofence>& geofences,
                               const ProofContext& proof_context, Ending& ending);

}  // namespace glider::ir::prove
