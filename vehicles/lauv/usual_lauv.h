// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/own_mission.h"

#include <memory>

namespace glider::lauv {

/// Upper bound from the SBC's last Reference until the propeller stops, s.
double letsGoWithin(const platforms::Platform& platform);

/// What a LAUV flies by itself: nothing. Without References it stops and floats up.
std::unique_ptr<vehicles::OwnMission> usualLauv();

}  // namespace glider::lauv
