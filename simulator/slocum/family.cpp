// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/family/family.h"

#include "simulator/sensors/provided.h"
#include "simulator/slocum/drawn.h"
#include "simulator/slocum/flight/skeleton.h"
#include "simulator/slocum/own_mission.h"
#include "simulator/slocum/slocum_seat.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace glider::simulator {
namespace {

constexpr std::string_view kVehicleKeys[] = {"code_15"};

/// The one in `own`, which is made if there is none.
SlocumMission& missionIn(std::any& own) {
  if (!own.has_value()) {
    own = SlocumMission();
  }
  return std::any_cast<SlocumMission&>(own);
}

bool hasHookbeh(const slocum::MissionFile& mission) {
  return std::ranges::any_of(mission.behaviours,
                             [](const auto& behaviour) { return behaviour.name == "hookbeh"; });
}

/// The list of the sensors on the port for a backseat driver, if it is in `config` beside the
/// mission file or beside its folder, as on the vehicle.
support::Result<void> loadExtctl(const std::filesystem::path& path, SlocumMission& mission) {
  for (const char* folder : {"config", "../config"}) {
    const std::filesystem::path file = path.parent_path() / folder / "extctl.ini";
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) {
      continue;
    }
    const auto text = support::readFile(file);
    auto read = text ? slocum::readExtctlFile(file.string(), *text)
                     : support::Result<slocum::ExtctlFile>(std::unexpected(text.error()));
    if (!read) {
      return std::unexpected(read.error());
    }
    mission.extctl = std::move(*read);
    return {};
  }
  return {};
}

support::Result<void> loadOwn(const std::filesystem::path& path, support::SourceManager& sources,
                              support::DiagnosticEngine& diagnostics, std::any& own) {
  auto file = loadMissionFile(path, sources, diagnostics);
  if (!file) {
    return std::unexpected(file.error());
  }
  SlocumMission& mission = missionIn(own);
  mission.file = std::move(*file);
  mission.extctl.reset();
  return hasHookbeh(mission.file) ? support::Result<void>() : loadExtctl(path, mission);
}

/// What code 15 of start_when and stop_when means to the vehicle's release.
void readCode15(Fields& fields, std::any& own) {
  const std::string text = fields.reader().textOr("code_15", "far_from_waypoint");
  if (text != "far_from_waypoint" && text != "mission_mode") {
    fields.reader().refuse("code_15", "must be \"far_from_waypoint\" or \"mission_mode\"");
  }
  missionIn(own).code_15 = text == "mission_mode" ? Code15::MissionMode : Code15::FarFromWaypoint;
}

/// The vehicle's mission file with what its argument files gave it.
std::string textOf(const std::any& own) {
  std::string text;
  for (const slocum::BehaviourBlock& behaviour :
       std::any_cast<const SlocumMission&>(own).file.behaviours) {
    text += behaviour.name + "\n";
    for (const slocum::Setting& setting : behaviour.arguments) {
      text += fmt::format("{} {}\n", setting.name, setting.value);
    }
  }
  return text;
}

void applyDrawnTo(const DrawnFaults& drawn, std::any& own) {
  applyDrawn(drawn, std::any_cast<SlocumMission&>(own).file);
}

/// That of abend.
double overtimeOf(const std::any& own) {
  if (!own.has_value()) {
    return 0;
  }
  for (const slocum::BehaviourBlock& behaviour :
       std::any_cast<const SlocumMission&>(own).file.behaviours) {
    if (behaviour.name == "abend") {
      return std::max(0.0, behaviour.value("overtime"));
    }
  }
  return 0;
}

std::optional<double> raiseOvertime(std::any& own, double seconds) {
  return own.has_value() ? slocum::raiseOvertime(std::any_cast<SlocumMission&>(own).file, seconds)
                         : std::nullopt;
}

std::optional<double> raiseNapSecs(std::any& own, double seconds) {
  return own.has_value() ? slocum::raiseNapSecs(std::any_cast<SlocumMission&>(own).file, seconds)
                         : std::nullopt;
}

std::unique_ptr<SimulatedSeat> makeSeat(const SeatSetup& setup) {
  return std::make_unique<SlocumSeat>(setup);
}

bool providesByName(const platforms::PlatformSensor& sensor) {
  return isProvided(sensor.name);
}

}  // namespace

// A constant of the program: initialisers that run before main() find it complete.
constinit const Family families::slocum = {.name = "slocum",
                                           .own_control = "layered control",
                                           .missing_sensor = missingSensor,
                                           .provides = providesByName,
                                           .load_own = loadOwn,
                                           .vehicle_keys = kVehicleKeys,
                                           .read_vehicle = readCode15,
                                           .text_of = textOf,
                                           .apply_drawn = applyDrawnTo,
                                           .overtime_of = overtimeOf,
                                           .raise_overtime = raiseOvertime,
                                           .raise_nap_secs = raiseNapSecs,
                                           .make_seat = makeSeat};

}  // namespace glider::simulator
