// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/scenario/scenario.h"
#include "tests/depths/depth_flight.h"

#include <set>
#include <vector>

namespace glider::tests {

/// The vehicle touched the bottom: when, where (m east and north of the start), how deep.
struct Contact {
  double time_s = 0;
  double east_m = 0, north_m = 0;
  double depth_m = 0;
  double lasts_s = 0;  ///< how long it lay there
  int echoes = 0;      ///< how many the altimeter had received before
};

/// What came of a flight over a bottom.
struct OverBottom {
  std::vector<Contact> contacts;
  double deepest_m = 0;      ///< by the vehicle itself
  double clearance_m = 1e9;  ///< the least over the bottom, below a metre of depth
  double on_bottom_s = 0;
  int guarded = 0;  ///< cycles in which a guard of hookbeh was active
  int dives = 0;
};

/// Flies `plan` through the real protocol.
OverBottom flyOverBottom(const Plan& plan, simulator::Scenario scenario, uint64_t seed);

/// A vehicle that lies on the bottom for less than this, s, touched it while it turned by itself.
inline constexpr double kStopsSecs = 48;

/// Contacts that come although an earlier one, at most `near_m` away, has stopped the vehicle and
/// so shown it where the bottom is: it is not more than `margin_m` shallower there.
std::vector<Contact> repeated(const std::vector<Contact>& contacts, double near_m, double margin_m);

}  // namespace glider::tests
