// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The vehicle of missions in C that name no other. An object of its own: the linker takes it only
// for them.
#define GLIDER_DEFINE_VEHICLE
#include "platforms/slocum_sensors.h"
