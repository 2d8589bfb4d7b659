// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/mission_files/argument_files.h"

#include "support/diagnostics/ids/vehicle.h"
#include "support/files.h"
#include "vehicles/slocum/mission_files/behaviour_catalogue.h"
#include "vehicles/slocum/mission_files/read.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::slocum {

std::string argumentFileName(std::string_view behaviour, int number) {
  return fmt::format("{}{:02}.ma", behaviour.substr(0, 6), number);
}

namespace {

/// Where the vehicle's argument files may lie relative to the mission file.
std::filesystem::path find(const std::filesystem::path& folder, const std::string& name) {
  for (const char* beside : {"mafiles", "../mafiles"}) {
    if (!std::filesystem::exists(folder / name) &&
        std::filesystem::exists(folder / beside / name)) {
      return folder / beside / name;
    }
  }
  return folder / name;
}

void apply(BehaviourBlock& block, const ArgumentFile& file,
           support::DiagnosticEngine& diagnostics) {
  if (file.behaviour != block.name) {
    diagnostics
        .report(support::diagnostics::argumentFileBehaviour, file.behaviour_range, file.behaviour,
                block.name)
        .note(block.range, "it is read here");
    return;
  }
  block.waypoints = file.waypoints;
  for (const Setting& setting : file.arguments) {
    const auto given = std::ranges::find(block.arguments, setting.name, &Setting::name);
    if (given != block.arguments.end()) {
      *given = setting;
    } else {
      block.arguments.push_back(setting);
    }
  }
}

}  // namespace

void applyArgumentFiles(MissionFile& mission, const std::filesystem::path& folder,
                        support::SourceManager& sources, support::DiagnosticEngine& diagnostics) {
  for (BehaviourBlock& block : mission.behaviours) {
    const Setting* from_file = block.find("args_from_file");
    if (from_file == nullptr || from_file->value < 0) {
      continue;
    }
    if (from_file->value > 99 || from_file->value != static_cast<int>(from_file->value)) {
      diagnostics.report(support::diagnostics::argumentValue, from_file->value_range,
                         from_file->name, from_file->value,
                         "it must be a whole number from 0 to 99, or -1 for none");
      continue;
    }
    const auto path =
        find(folder, argumentFileName(block.name, static_cast<int>(from_file->value)));
    auto text = support::readFile(path);
    if (!text && !drivesMotors(block.name)) {
      block.lacks_file = true;
      diagnostics.report(support::diagnostics::argumentFileMissing, from_file->value_range,
                         path.filename().string(), block.name);
      continue;
    }
    if (!text) {
      diagnostics.add({text.error().id,
                       support::Severity::Error,
                       from_file->value_range,
                       text.error().message,
                       text.error().hint,
                       {},
                       {}});
      continue;
    }
    const uint32_t file = sources.add(path.string(), std::move(*text));
    if (const auto arguments = readArguments(sources, file, diagnostics)) {
      apply(block, *arguments, diagnostics);
    }
  }
}

}  // namespace glider::slocum
