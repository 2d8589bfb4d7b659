// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_tables/merge.h"

#include <string>

namespace glider::slocum {

/// The table as comma-separated values: time_s, computer and the sensors; a field is empty where
/// the record does not update the sensor.
std::string csvOf(const Merged& merged);

}  // namespace glider::slocum
