// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "vehicles/slocum/mission_files/mission_file.h"
#include "vehicles/slocum/rules/layers.h"
#include "vehicles/slocum/rules/vehicle_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace glider::slocum::rules {

/// A mission file of the vehicle whose `yo` takes its arguments from mission parameters, which the
/// SBC sets by the port for a backseat driver. Nothing in it watches the SBC.
struct PortFile {
  std::vector<Layer> layers;  ///< the SBC's `yo` flies, without an end, to deepest_m
  size_t driven = 0;          ///< the number of the SBC's `yo`, from 1
  double deepest_m = 0;       ///< for any command of the SBC; infinite without an overdepth
};

/// Whether the file, which has no hookbeh, is one of the port.
bool isPortFile(const MissionFile& file);

/// Of a file for which isPortFile() holds.
PortFile portFileOf(const MissionFile& file, const platforms::Platform& platform);

/// The limits of that file, and those of the programs that fly with it.
VehicleFile portVehicleFile(const MissionFile& file, const std::string& path,
                            const platforms::Platform& platform);

/// Widens the vehicle to one that obeys by the port. The SBC's end needs time until a command is
/// obeyed: a depth waits for a cycle in which those that it must not meet at the other end of the
/// yo are over, and then crosses. An outage of the program of up to `outage_s` may come between the
/// two ends. A depth to which the vehicle has climbed is held by a yo below it. And what is read at
/// a tick was so some seconds ago.
void widenForPort(platforms::Platform& platform, double outage_s);

}  // namespace glider::slocum::rules
