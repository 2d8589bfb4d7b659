// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_traces/samples.h"

#include <string>
#include <vector>

namespace glider::slocum {

/// The sensors from which depth is known, the best one first.
std::vector<std::string> depthSensors();

/// The depth in m: m_depth, and where it was not logged for a while, 10 m for each bar of
/// m_pressure, otherwise of sci_water_pressure.
Samples depthOf(const Merged& merged);

}  // namespace glider::slocum
