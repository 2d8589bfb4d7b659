// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/sbc_choice.h"

#include "codegen/codegen.h"
#include "codegen/load/loaded_mission.h"
#include "driver/boards.h"
#include "driver/in_process_sbc.h"
#include "simulator/science/process_sbc_port.h"

namespace glider::driver {

using simulator::ProcessSbcPort;
using simulator::SbcPort;
using support::Result;

Result<std::unique_ptr<SbcPort>> sbcInProcess(const Compilation& compilation) {
  const auto host = loadTarget("host");
  if (!host) {
    return std::unexpected(host.error());
  }
  codegen::CodegenOptions options;
  options.debug = false;
  const auto object = codegen::linkShared(*compilation.mission, compilation.facts, *host, options);
  if (!object) {
    return std::unexpected(object.error());
  }
  auto loaded = codegen::LoadedMission::load(*object);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  return std::make_unique<InProcessSbc>(std::move(*loaded));
}

Result<std::unique_ptr<SbcPort>> sbcOnBoard(const Compilation& compilation,
                                            const std::string& board, const std::string& name,
                                            const std::filesystem::path& folder) {
  const auto target = loadTarget(board);
  if (!target) {
    return std::unexpected(target.error());
  }
  const std::filesystem::path binary = folder / (name + "-" + board);
  codegen::CodegenOptions options;
  options.sources = &compilation.sources;
  const auto built =
      codegen::linkExecutable(*compilation.mission, compilation.facts, *target, options, binary);
  if (!built) {
    return std::unexpected(built.error());
  }
  std::vector<std::string> command = target->emulator;
  const std::filesystem::path log = folder / "mission-log.csv";
  std::error_code ignored;
  std::filesystem::remove(log, ignored);  // of an earlier flight: the program would write after it
  for (const std::string& word : {std::filesystem::absolute(binary).string(), std::string("--port"),
                                  std::string("{port}"), std::string("--log"), log.string()}) {
    command.push_back(word);
  }
  return ProcessSbcPort::start(board, std::move(command));
}

Result<std::unique_ptr<SbcPort>> sbcProgram(const std::string& program) {
  // A file that lies here is meant, not one of that name somewhere in PATH.
  std::error_code ignored;
  const bool here = std::filesystem::is_regular_file(program, ignored);
  return ProcessSbcPort::start(
      "program",
      {here ? std::filesystem::absolute(program).string() : program, "--port", "{port}"});
}

}  // namespace glider::driver
