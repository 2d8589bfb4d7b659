// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "vehicles/slocum/mission_files/mission_file.h"
#include "vehicles/slocum/rules/layers.h"
#include "vehicles/slocum/rules/whole.h"

#include <span>
#include <vector>

namespace glider::slocum::rules {

/// Adds how the vehicle comes up after each abort of its `abend`, if it has one. After an abort no
/// behaviour is called: the vehicle itself climbs. `deepest_m`: of all that the layers and the
/// mission command.
void addAborts(const MissionFile& vehicle, std::span<const Layer> layers,
               const platforms::Platform& platform, double deepest_m, std::vector<Ending>& endings);

/// How deep the vehicle may be, m, when the depth is found to be greater than overdepth of `abend`.
double abortsWithin(const BehaviourBlock& abend, const platforms::Platform& platform);

}  // namespace glider::slocum::rules
