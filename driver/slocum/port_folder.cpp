// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/port_folder.h"

#include "analysis/mission_budget.h"
#include "codegen/codegen.h"
#include "codegen/digest.h"
#include "compiler/user_code.h"
#include "driver/output/executable.h"
#include "driver/slocum/port_page.h"
#include "driver/slocum/port_sources.h"
#include "driver/terminal.h"
#include "platforms/load/toml_reader.h"
#include "simulator/slocum/own_mission.h"
#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/target.h"
#include "support/diagnostics/ids/verification.h"
#include "support/files.h"
#include "vehicles/slocum/port_files/mission_port.h"
#include "vehicles/slocum/rules/port/port_whole.h"
#include "vehicles/slocum/rules/port_commands.h"
#include "vehicles/slocum/rules/refused_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <system_error>
#include <utility>

namespace glider::driver {
namespace {

constexpr const char* kDescription = "port.toml";
constexpr const char* kSensors = "vehicle/config/extctl.ini";

/// The file names of a folder.
struct Names {
  Names(std::string mission_file, const std::string& stem, const std::string& vehicle_file)
      : mission(std::move(mission_file)),
        program("sbc/" + stem),
        vehicle_mission("vehicle/missions/" + vehicle_file + ".mi") {}
  std::string mission, program, vehicle_mission;
  std::string sensors = kSensors;
  std::string proglet = "vehicle/config/proglets.txt";
  std::string page = "README.md";
};

slocum::Release releaseOf(const std::string& name) {
  return name == "mission-mode" ? slocum::Release::MissionModes : slocum::Release::Common;
}

/// The deepest that the mission commands, if that is known and the vehicle goes there. What code in
/// C commands is not known.
double depthFor(const compiler::Optimised& mission) {
  const double most = mission.platform().envelope.greatest_depth_m;
  const bool in_c = std::ranges::any_of(
      mission.mission.behaviours, [](const auto& behaviour) { return !behaviour.symbol.empty(); });
  double deepest = 0;
  for (const auto& dive : slocum::rules::divesOf(mission.mission)) {
    deepest = std::max(deepest, dive.depth_m);
  }
  return deepest > 0 && !in_c ? std::min(deepest, most) : most;
}

slocum::PortChoice choiceOf(const PortOptions& options, const compiler::Optimised& mission) {
  slocum::PortChoice choice;
  choice.release = releaseOf(options.release);
  choice.greatest_depth_m = std::min(options.greatest_depth_m.value_or(depthFor(mission)),
                                     mission.platform().envelope.greatest_depth_m);
  choice.surface_after_s = options.surface_after_s.value_or(choice.surface_after_s);
  choice.most_sensors = options.sensors;
  return choice;
}

std::string descriptionOf(const Names& names, const slocum::PortChoice& choice,
                          const PortOptions& options) {
  return fmt::format(
      "# Written by glidercc build --dialect extctl: how the files of this folder belong "
      "together.\n"
      "mission = \"{}\"\nvehicle_mission = \"{}\"\nrelease = \"{}\"\ngreatest_depth_m = {}\n"
      "least_altitude_m = {}\nsurface_after_s = {}\nport_sensors = {}\n",
      names.mission, names.vehicle_mission, options.release, choice.greatest_depth_m,
      choice.least_altitude_m, choice.surface_after_s, choice.most_sensors);
}

/// Commands that the program would refuse at sea (GL3124).
void checkDepths(const compiler::Optimised& flown, double greatest_depth_m,
                 support::DiagnosticEngine& diagnostics) {
  const ir::Mission& mission = flown.checked->mission();
  const bool of_vehicle = greatest_depth_m >= flown.platform().envelope.greatest_depth_m;
  for (const auto& dive : slocum::rules::divesOf(mission)) {
    if (dive.depth_m > greatest_depth_m) {
      diagnostics.report(
          support::diagnostics::vehicleRefuses,
          dive.range.valid() ? dive.range : mission.states.front().range, dive.who,
          fmt::format("a depth of {:.4g} m", dive.depth_m), "its program",
          fmt::format("more than {:.4g} m", greatest_depth_m),
          of_vehicle ? fmt::format("the greatest depth of the platform `{}`", flown.platform().name)
                     : "`--max-depth`");
    }
  }
}

/// False, with the errors shown, if the port cannot give all commands of the mission.
bool canBeFlown(const compiler::Optimised& mission, const slocum::PortChoice& choice) {
  support::DiagnosticEngine diagnostics;
  slocum::rules::checkPortCommands(mission.mission, diagnostics);
  checkDepths(mission, choice.greatest_depth_m, diagnostics);
  reportDiagnostics(diagnostics, mission.sources());
  return diagnostics.errorCount() == 0;
}

support::Result<void> makeFolders(const std::filesystem::path& folder, const PortSources& sources) {
  std::vector<std::filesystem::path> parts{"sbc", "vehicle/missions", "vehicle/config"};
  for (const auto& [name, text] : sources.files) {
    parts.push_back(std::filesystem::path(name).parent_path());
  }
  std::error_code error;
  for (const std::filesystem::path& part : parts) {
    std::filesystem::create_directories(folder / part, error);
    if (error) {
      return support::fail(support::diagnostics::cannotWrite, (folder / part).string(),
                           error.message());
    }
  }
  return {};
}

support::Result<void> writeTexts(const std::filesystem::path& folder,
                                 const std::vector<std::pair<std::string, std::string>>& texts) {
  std::vector<support::StagedFile> staged;
  for (const auto& [name, text] : texts) {
    auto file = support::StagedFile::write(folder / name, text, support::FileKind::Document);
    if (!file) {
      return std::unexpected(file.error());
    }
    staged.push_back(std::move(*file));
  }
  for (support::StagedFile& file : staged) {
    if (auto published = file.publish(); !published) {
      return published;
    }
  }
  return {};
}

/// Its sensors, by index.
std::vector<std::string> namesOf(const slocum::ExtctlFile& list) {
  std::vector<std::string> names;
  for (const slocum::ExtctlSensor& sensor : list.sensors()) {
    names.push_back(sensor.name);
  }
  return names;
}

/// The number of the program in a mission file, as it is written: the vehicle takes the last line.
std::string programNumberIn(const std::string& text) {
  static const std::regex line(
      "(^|\n)[ \t]*sensor:[ \t]*u_mission_param_l[ \t]*\\([^)\n]*\\)[ \t]*([^ \t\r\n#]*)",
      std::regex::icase);
  std::string number;
  for (std::sregex_iterator at(text.begin(), text.end(), line), end; at != end; ++at) {
    number = (*at)[2];
  }
  return number;
}

}  // namespace

support::Result<bool> writePortFolder(const PortOptions& options,
                                      const std::filesystem::path& folder,
                                      const std::string& mission_file,
                                      const platforms::Board& board,
                                      const std::vector<std::string>& user_code,
                                      const compiler::Optimised& mission) {
  const slocum::PortChoice choice = choiceOf(options, mission);
  if (!canBeFlown(mission, choice)) {
    return false;
  }
  const auto plan = slocum::planFor(mission, choice);
  const auto code = compiler::loadUserCode(user_code, mission.mission, board);
  const auto sources = portSources(mission, mission_file, stemOf(mission_file) + ".mission");
  for (const auto* failure : {plan ? nullptr : &plan.error(), code ? nullptr : &code.error(),
                              sources ? nullptr : &sources.error()}) {
    if (failure != nullptr) {
      return std::unexpected(*failure);
    }
  }
  const bool there = std::filesystem::exists(folder);
  if (auto made = makeFolders(folder, *sources); !made) {
    return std::unexpected(made.error());
  }
  const Names names(sources->mission, stemOf(mission_file), plan->file);
  codegen::CodegenOptions how = buildOptions(mission, kUsualLevel);
  how.port = plan->port;
  if (!options.ignore_limits) {
    how.accepts = analysis::onlyWhatFits(board, mission);
  }
  code->addTo(how);
  if (auto linked = codegen::linkExecutable(mission.input(), board, how, folder / names.program);
      !linked) {
    if (std::error_code ignored; !there) {
      std::filesystem::remove_all(folder, ignored);
    }
    return std::unexpected(linked.error());
  }
  const std::string comment =
      fmt::format("The sensors on the port of the mission {}.", plan->mission);
  const slocum::rules::Whole whole = slocum::rules::portWhole(*plan, mission.platform());
  std::vector<std::pair<std::string, std::string>> texts = {
      {names.vehicle_mission, slocum::printPortMission(*plan)},
      {names.sensors, slocum::printExtctlFile(plan->extctl, comment)},
      {names.proglet, slocum::printProglet(*plan)},
      {names.page,
       portPage(*plan,
                {names.program, names.vehicle_mission, names.sensors, names.proglet, board.name},
                whole.endings.front())},
      {kDescription, descriptionOf(names, choice, options)}};
  texts.insert(texts.end(), sources->files.begin(), sources->files.end());
  const auto written = writeTexts(folder, texts);
  return written ? support::Result<bool>(true) : std::unexpected(written.error());
}

bool isPortFolder(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path / kDescription, ignored);
}

namespace {

/// port.toml.
struct Description {
  PortFolder missions;
  slocum::PortChoice choice;
};

support::Result<Description> readDescription(const std::filesystem::path& folder) {
  const auto table = platforms::parseToml(folder / kDescription);
  if (!table) {
    return std::unexpected(table.error());
  }
  platforms::TomlReader reader((folder / kDescription).string(), *table, "");
  Description read;
  read.missions.mission = folder / reader.text("mission");
  read.missions.vehicle_mission = folder / reader.text("vehicle_mission");
  read.choice.release = releaseOf(reader.text("release"));
  read.choice.greatest_depth_m = reader.number("greatest_depth_m");
  read.choice.least_altitude_m = reader.number("least_altitude_m");
  read.choice.surface_after_s = reader.number("surface_after_s");
  read.choice.most_sensors = static_cast<uint32_t>(reader.integer("port_sensors"));
  return reader.failure() ? support::Result<Description>(std::unexpected(*reader.failure()))
                          : std::move(read);
}

}  // namespace

support::Result<PortFolder> openPortFolder(const std::filesystem::path& path) {
  auto read = readDescription(path);
  return read ? support::Result<PortFolder>(read->missions) : std::unexpected(read.error());
}

support::Result<std::optional<PortFolder>> portFolderAt(const std::filesystem::path& path) {
  if (!isPortFolder(path)) {
    return std::nullopt;
  }
  auto folder = openPortFolder(path);
  return folder ? support::Result<std::optional<PortFolder>>(std::move(*folder))
                : std::unexpected(folder.error());
}

support::Result<void> useChoice(const std::filesystem::path& folder,
                                simulator::Scenario& scenario) {
  const auto read = readDescription(folder);
  if (!read) {
    return std::unexpected(read.error());
  }
  simulator::SlocumMission& flown = simulator::slocumMissionOf(scenario);
  flown.code_15 = read->choice.release == slocum::Release::MissionModes
                      ? simulator::Code15::MissionMode
                      : simulator::Code15::FarFromWaypoint;
  flown.program_depth_m = read->choice.greatest_depth_m;
  return {};
}

support::Result<FolderPort> readFolderPort(const std::filesystem::path& folder,
                                           const compiler::Optimised& mission) {
  const auto read = readDescription(folder);
  if (!read) {
    return std::unexpected(read.error());
  }
  const auto plan = slocum::planFor(mission, read->choice);
  if (!plan) {
    return std::unexpected(plan.error());
  }
  const auto text = support::readFile(read->missions.vehicle_mission);
  if (!text) {
    return std::unexpected(text.error());
  }
  // Pilots add their own behaviours; the number says that the rest belongs together.
  if (programNumberIn(*text) != std::to_string(plan->port.program)) {
    return support::fail(support::diagnostics::notPortFolder, folder.string(),
                         fmt::format("`{}` was written for another mission, or with other options",
                                     read->missions.vehicle_mission.filename().string()));
  }
  const std::filesystem::path list = folder / kSensors;
  const auto lines = support::readFile(list);
  auto sensors = lines ? slocum::readExtctlFile(list.string(), *lines)
                       : support::Result<slocum::ExtctlFile>(std::unexpected(lines.error()));
  if (!sensors) {
    return std::unexpected(sensors.error());
  }
  return FolderPort{*plan, std::move(*sensors)};
}

support::Result<flights::PortEnd> portEndOf(const std::filesystem::path& folder,
                                            const compiler::Optimised& mission) {
  const auto port = readFolderPort(folder, mission);
  if (!port) {
    return std::unexpected(port.error());
  }
  // Both sides name sensors by their place in the list.
  if (port->sensors.baud != port->plan.extctl.baud ||
      namesOf(port->sensors) != namesOf(port->plan.extctl)) {
    return support::fail(support::diagnostics::notPortFolder, folder.string(),
                         fmt::format("`{}` lists other sensors, or another speed, than the program "
                                     "was built with",
                                     std::filesystem::path(kSensors).filename().string()));
  }
  const auto last = static_cast<uint32_t>(port->plan.extctl.sensors().size()) - 1;
  return flights::PortEnd{port->plan.port, last, port->sensors.baud};
}

}  // namespace glider::driver
