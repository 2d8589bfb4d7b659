// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <string>

namespace glider::simulator {

/// How far the pitch battery of the Slocum moves to either side, in.
inline constexpr double kBatteryTravelIn = 1.425;

/// Reports the values that the vehicle or this simulator does not have for the b_args of a known
/// behaviour (GL5107), those that the vehicle clips (GL5206), and those whose effect is not
/// simulated (GL5116).
void checkValues(const slocum::BehaviourBlock& block, support::DiagnosticEngine& diagnostics);

/// Reports that `given` cannot have its value (GL5107).
void refuseValue(const slocum::BehaviourBlock& block, const slocum::Setting& given,
                 const std::string& why, support::DiagnosticEngine& diagnostics);

}  // namespace glider::simulator
