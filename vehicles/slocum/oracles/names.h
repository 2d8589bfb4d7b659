// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight_observer.h"

/// The checks of a flight speak of it in the simulator's words.
namespace glider::slocum::oracles {

using namespace simulator;

}  // namespace glider::slocum::oracles
