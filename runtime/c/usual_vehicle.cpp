// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The default vehicle of missions in C. It is a separate object file so that the linker takes it
// only for missions that name no other vehicle.
#define GLIDER_DEFINE_VEHICLE
#include "platforms/slocum_sensors.h"
