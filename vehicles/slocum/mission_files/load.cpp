// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/mission_files/load.h"

#include "support/diagnostics/ids/vehicle.h"
#include "support/files.h"
#include "vehicles/slocum/mission_files/argument_files.h"
#include "vehicles/slocum/mission_files/read.h"

#include <string>
#include <utility>

namespace glider::slocum {
namespace {

/// What the vehicle reads before each mission; empty if it is not there.
std::filesystem::path autoexecOf(const std::filesystem::path& mission) {
  constexpr const char* kName = "autoexec.mi";
  for (const char* folder : {"", "config", "../config"}) {
    const auto path = mission.parent_path() / folder / kName;
    if (std::filesystem::is_regular_file(path) && mission.filename() != kName) {
      return path;
    }
  }
  return {};
}

void readAutoexec(const std::filesystem::path& path, MissionFile& mission,
                  support::SourceManager& sources, support::DiagnosticEngine& diagnostics) {
  auto text = support::readFile(path);
  if (!text) {
    return;  // there is none
  }
  const uint32_t file = sources.add(path.string(), std::move(*text));
  if (const auto vehicle = readMission(sources, file, diagnostics)) {
    mission.vehicle_sensors = vehicle->sensors;
  }
}

}  // namespace

support::Result<MissionFile> loadMission(const std::filesystem::path& path,
                                         support::SourceManager& sources,
                                         support::DiagnosticEngine& diagnostics,
                                         const CheckMission& check) {
  auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  const size_t errors_before = diagnostics.errorCount();
  const std::string name = path.string();
  const uint32_t file = sources.add(name, std::move(*text));
  auto mission = readMission(sources, file, diagnostics);
  if (mission) {
    readAutoexec(autoexecOf(path), *mission, sources, diagnostics);
    applyArgumentFiles(*mission, path.parent_path(), sources, diagnostics);
    check(*mission, {file, 0, 0}, diagnostics);
  }
  if (!mission || diagnostics.errorCount() != errors_before) {
    return support::fail(support::diagnostics::skeletonErrors, name,
                         diagnostics.errorCount() - errors_before);
  }
  return std::move(*mission);
}

}  // namespace glider::slocum
