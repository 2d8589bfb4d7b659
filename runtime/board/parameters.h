// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/board/options.h"
#include "runtime/launch/launch.h"

/// The parameters of a mission on a board: from the command line and a file.
namespace glider::runtime {

/// Sets the parameters of `launch` from the options, the file first. Returns false, with the reason
/// on standard error, if the mission does not allow the values.
bool setParameters(const Options& options, Launch& launch);

/// Lists the parameters with their defaults and ranges, for --help.
void tellParameters(const GliderMission& mission);

}  // namespace glider::runtime
