// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/scenario/scenario.h"
#include "support/result.h"

#include <string>

namespace glider::driver {

/// Makes `command`, a program with its arguments, act as the science computer of the vehicle in
/// `scenario`. GL9151 if it cannot, also on a vehicle that has no hookprog.
support::Result<void> useScienceProgram(const std::string& command,
                                        const platforms::Platform& platform,
                                        simulator::Scenario& scenario);

}  // namespace glider::driver
