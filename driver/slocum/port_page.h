// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/port_files/port_plan.h"
#include "vehicles/slocum/rules/whole.h"

#include <string>

namespace glider::driver {

/// The files that the page speaks of, by their names in the folder.
struct PortPageFiles {
  std::string program, vehicle_mission, sensors, proglet;
  std::string board;  ///< that the program is for
};

/// The page that says what goes where, what to type at the dock, and what `silence` of the SBC
/// leads to, as Markdown. That is proved about the mission file.
std::string portPage(const slocum::PortPlan& plan, const PortPageFiles& files,
                     const slocum::rules::Ending& silence);

}  // namespace glider::driver
