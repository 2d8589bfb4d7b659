// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/sbc_choice.h"

#include "codegen/codegen.h"
#include "codegen/seat_mission.h"
#include "compiler/boards.h"
#include "compiler/user_code.h"
#include "flights/in_process_sbc.h"
#include "flights/shadowed_sbc.h"
#include "simulator/ports/process_sbc_port.h"
#include "simulator/ports/serial_sbc_port.h"

#include <algorithm>
#include <limits>

namespace glider::flights {
namespace {

/// Of a serial line, where one takes the place of the network.
constexpr uint32_t kSerialBaud = 115200;

}  // namespace

using simulator::ProcessSbcPort;
using simulator::SbcPort;
using simulator::SerialSbcPort;
using simulator::StartSbc;
using support::Result;

Result<std::optional<PortEnd>> usualEnd(const platforms::Platform& platform) {
  const auto end = [](const auto& known) -> Result<std::optional<PortEnd>> {
    if (!known) {
      return std::unexpected(known.error());
    }
    return PortEnd{*known, 0, kSerialBaud};
  };
  return codegen::speaksImc(platform)     ? end(codegen::imcMissionOf(platform))
         : codegen::speaksRecon(platform) ? end(codegen::reconMissionOf(platform))
                                          : std::nullopt;
}

Result<NewWatchedFlight> flightsInProcess(const compiler::Optimised& mission,
                                          const LaunchChoice& launch,
                                          const std::vector<std::string>& user_code,
                                          bool keeps_time, const std::optional<PortEnd>& port) {
  auto loaded = loadHere(mission, user_code);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  auto parameters = chooseParameters(mission.mission, launch);
  if (!parameters) {
    return std::unexpected(parameters.error());
  }
  auto shared = std::make_shared<const codegen::LoadedMission>(std::move(*loaded));
  return [shared, values = std::move(*parameters), keeps_time, port,
          turn = launch.turn](RequirementWatch* watch) {
    return startInProcess(shared, values, keeps_time, watch, port, turn);
  };
}

StartSbc startInProcess(std::shared_ptr<const codegen::LoadedMission> mission,
                        std::vector<double> parameters, bool keeps_time, RequirementWatch* watch,
                        const std::optional<PortEnd>& port, const std::optional<Turn>& turn) {
  return [mission = std::move(mission), parameters = std::move(parameters), keeps_time, watch, port,
          turn, card = std::make_shared<Card>()]() -> Result<std::unique_ptr<SbcPort>> {
    auto sbc = std::make_unique<InProcessSbc>(mission, parameters, card, keeps_time, port);
    if (watch != nullptr) {
      sbc->watch(watch->watcher(parameters, sbc->kept()));
    }
    if (turn) {
      sbc->talk(*turn);
    }
    return sbc;
  };
}

Result<StartSbc> sbcInProcess(const compiler::Optimised& mission, const LaunchChoice& launch,
                              const std::vector<std::string>& user_code, bool keeps_time,
                              RequirementWatch* watch, const std::optional<PortEnd>& port) {
  const auto flights = flightsInProcess(mission, launch, user_code, keeps_time, port);
  return flights ? Result<StartSbc>((*flights)(watch)) : std::unexpected(flights.error());
}

namespace {

StartSbc starterOf(std::string way, std::vector<std::string> command,
                   std::filesystem::path card = {}, double hang_secs = ProcessSbcPort::kHangSecs,
                   const std::optional<PortEnd>& port = {}) {
  return [way = std::move(way), command = std::move(command), card = std::move(card), hang_secs,
          port]() -> Result<std::unique_ptr<SbcPort>> {
    return ProcessSbcPort::start(way, command, hang_secs, card,
                                 port ? port->turns() : simulator::hookTurns());
  };
}

}  // namespace

Result<std::vector<std::string>> buildOnBoard(const compiler::Optimised& mission,
                                              const LaunchChoice& launch,
                                              const std::vector<std::string>& user_code,
                                              const std::string& board,
                                              const std::filesystem::path& binary,
                                              const std::optional<PortEnd>& port) {
  // Before the board's program refuses them.
  if (auto allowed = chooseParameters(mission.mission, launch); !allowed) {
    return std::unexpected(allowed.error());
  }
  const auto target = compiler::loadTarget(board);
  if (!target) {
    return std::unexpected(target.error());
  }
  const auto code = compiler::loadUserCode(user_code, mission.mission, *target);
  if (!code) {
    return std::unexpected(code.error());
  }
  codegen::CodegenOptions options;
  options.sources = &mission.sources();
  const auto* slocum = port ? std::get_if<GliderPortMission>(&port->mission) : nullptr;
  options.port = slocum != nullptr ? std::optional(*slocum) : std::nullopt;
  code->addTo(options);
  const auto built = codegen::linkExecutable(mission.input(), *target, options, binary);
  if (!built) {
    return std::unexpected(built.error());
  }
  std::vector<std::string> command = target->emulator;
  command.push_back(std::filesystem::absolute(binary).string());
  return command;
}

StartSbc startOnBoard(const std::string& board, std::vector<std::string> command,
                      const LaunchChoice& launch, const std::filesystem::path& folder,
                      const std::string& name, double hang_secs,
                      const std::optional<PortEnd>& port) {
  const std::filesystem::path log = folder / "mission.log";
  const std::filesystem::path checkpoints = folder / (name + ".checkpoint");
  std::error_code ignored;
  for (const auto& of_an_earlier_flight : {log, checkpoints}) {
    std::filesystem::remove(of_an_earlier_flight, ignored);
  }
  command.insert(command.end(),
                 {"--port", "{port}", "--log", log.string(), "--checkpoint", checkpoints.string()});
  if (!launch.file.empty()) {
    command.insert(command.end(), {"--parameters", launch.file});
  }
  for (const std::string& setting : launch.settings) {
    command.insert(command.end(), {"--set", setting});
  }
  return starterOf(board, std::move(command), checkpoints, hang_secs, port);
}

namespace {

/// The command that runs `binary` on the board, waiting for a debugger on `port`.
Result<std::vector<std::string>> underDebugger(const std::string& board, uint16_t port,
                                               const std::string& binary) {
  const auto target = compiler::loadTarget(board);
  if (!target) {
    return std::unexpected(target.error());
  }
  std::vector<std::string> command = target->debugger;
  std::ranges::replace(command, std::string("{port}"), std::to_string(port));
  command.push_back(binary);
  return command;
}

}  // namespace

Result<StartSbc> sbcOnBoard(const compiler::Optimised& mission, const LaunchChoice& launch,
                            const std::vector<std::string>& user_code, const BoardChoice& choice,
                            const std::string& name, const std::filesystem::path& folder,
                            RequirementWatch* watch, const std::optional<PortEnd>& port) {
  const std::string& board = choice.board;
  const std::string full_name = name + "-" + board;
  auto command = buildOnBoard(mission, launch, user_code, board, folder / full_name, port);
  if (command && choice.debugger) {
    command = underDebugger(board, *choice.debugger, command->back());
  }
  if (!command) {
    return std::unexpected(command.error());
  }
  const double hang_secs =
      choice.debugger ? std::numeric_limits<double>::infinity() : ProcessSbcPort::kHangSecs;
  StartSbc flown =
      startOnBoard(board, std::move(*command), launch, folder, full_name, hang_secs, port);
  if (watch == nullptr) {
    return flown;
  }
  auto shadow = sbcInProcess(mission, launch, user_code, false, watch, port);
  return shadow ? Result<StartSbc>(shadowed(std::move(flown), std::move(*shadow), *watch))
                : std::unexpected(shadow.error());
}

StartSbc sbcOnSerialLine(const std::string& device, bool lockstep,
                         const std::optional<PortEnd>& port) {
  const auto pace = lockstep ? SerialSbcPort::Pace::Lockstep : SerialSbcPort::Pace::RealTime;
  return [device, pace, port]() -> Result<std::unique_ptr<SbcPort>> {
    return port ? SerialSbcPort::open(device, pace, port->baud, port->turns())
                : SerialSbcPort::open(device, pace);
  };
}

StartSbc sbcProgram(const std::string& program, const std::optional<PortEnd>& port) {
  // A file in the current folder takes precedence over one of that name in PATH.
  std::error_code ignored;
  const bool here = std::filesystem::is_regular_file(program, ignored);
  return starterOf(
      "program", {here ? std::filesystem::absolute(program).string() : program, "--port", "{port}"},
      {}, ProcessSbcPort::kHangSecs, port);
}

Result<StartSbc> sbcProgramOf(const compiler::Optimised& mission,
                              const std::vector<std::string>& user_code, const std::string& program,
                              RequirementWatch* watch, const std::optional<PortEnd>& port) {
  if (watch == nullptr) {
    return sbcProgram(program, port);
  }
  auto shadow = sbcInProcess(mission, {}, user_code, false, watch, port);
  return shadow ? Result<StartSbc>(shadowed(sbcProgram(program, port), std::move(*shadow), *watch))
                : std::unexpected(shadow.error());
}

}  // namespace glider::flights
