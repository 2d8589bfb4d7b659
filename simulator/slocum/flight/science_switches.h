// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/instrument.h"
#include "simulator/slocum/flight/mission_variables.h"
#include "simulator/slocum/science/sample_periods.h"

#include <string_view>
#include <vector>

namespace glider::simulator {

/// What a behaviour sample orders in one cycle.
struct SampleOrder {
  int sensor_type = 0;   ///< 0: all instruments
  double period_s = -1;  ///< negative: no readings now
};

/// Whether `name` is a setting of the mission that switches simulated instruments:
/// c_science_all_on, c_science_all_on_enabled, c_profile_on.
bool isScienceSwitch(std::string_view name);

/// How often the instruments sample. While c_science_all_on_enabled is 1, as it is unless the
/// mission sets it, they are all switched together: each order counts for all, and without orders
/// c_science_all_on decides. While it is 0, an order counts for its own instrument, and without
/// orders c_profile_on and the like decide. Of several orders the fastest counts. What is not set
/// is on.
SamplePeriods samplePeriods(const std::vector<SampleOrder>& orders,
                            const MissionVariables& variables);

/// Replaces those that the SBC orders: `word` of hooks/protocol/sampling.h, for the instruments
/// that the platform file lists.
void orderSamples(uint32_t word, const std::vector<platforms::Instrument>& instruments,
                  SamplePeriods& periods);

}  // namespace glider::simulator
