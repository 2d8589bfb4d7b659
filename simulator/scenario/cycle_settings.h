// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// How long the control cycles take. Those of real vehicles are neither of the nominal length nor
/// equal: 4.4 s on average on gliders of 2014, and some of 15 s while a device is slow.
struct CycleSettings {
  double mean_s = 0;    ///< of the usual ones; 0: as the platform file says
  double spread_s = 0;  ///< their standard deviation
  double long_share = 0;
  double long_s = 15;
};

}  // namespace glider::simulator
