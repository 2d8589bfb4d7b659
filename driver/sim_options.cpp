// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/sim_options.h"

#include "compiler/vehicles_own.h"
#include "driver/output/executable.h"
#include "driver/slocum/port_folder.h"
#include "flights/sbc_choice.h"

#include <filesystem>

namespace glider::driver {

std::string flightName(const SimOptions& options) {
  const std::string named = !options.mission.empty()   ? options.mission
                            : !options.program.empty() ? options.program
                                                       : options.serial;
  const std::string stem = stemOf(named);
  return stem.empty() ? "layered" : stem;
}

bool isVehiclesOwn(const SimOptions& options) {
  return compiler::kindOf(options.mission) == compiler::MissionKind::Vehicles;
}

bool isInProcess(const SimOptions& options) {
  return !options.without_sbc && options.serial.empty() && options.program.empty() &&
         options.board.empty();
}

std::string outputFolder(const SimOptions& options) {
  return options.output.empty() ? flightName(options) + "-flight" : options.output;
}

support::Result<simulator::StartSbc> chooseSbc(const SimOptions& options,
                                               const compiler::Optimised* mission, bool keeps_time,
                                               const std::filesystem::path& folder,
                                               flights::RequirementWatch* watch) {
  const bool other_sbc = !options.program.empty() || !options.serial.empty();
  if (options.without_sbc || (isVehiclesOwn(options) && !other_sbc)) {
    return simulator::StartSbc();
  }
  std::optional<flights::PortEnd> port;
  if (!options.port_folder.empty()) {
    auto end = portEndOf(options.port_folder, *mission);
    if (!end) {
      return std::unexpected(end.error());
    }
    port = *end;
  } else if (mission != nullptr) {
    auto end = flights::usualEnd(mission->platform());
    if (!end) {
      return std::unexpected(end.error());
    }
    port = *end;
  }
  if (!options.serial.empty()) {
    return flights::sbcOnSerialLine(options.serial, options.lockstep, port);
  }
  if (!options.program.empty()) {
    return mission != nullptr
               ? flights::sbcProgramOf(*mission, options.user_code, options.program, watch, port)
               : flights::sbcProgram(options.program);
  }
  if (isInProcess(options)) {
    return flights::sbcInProcess(*mission, options.launch, options.user_code, keeps_time, watch,
                                 port);
  }
  return flights::sbcOnBoard(*mission, options.launch, options.user_code,
                             {options.board, options.debugger}, flightName(options), folder, watch,
                             port);
}

}  // namespace glider::driver
