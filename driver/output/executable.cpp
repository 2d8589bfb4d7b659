// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/executable.h"

#include "codegen/codegen.h"
#include "codegen/digest.h"
#include "compiler/boards.h"
#include "compiler/user_code.h"
#include "driver/output/flight_folder.h"
#include "support/diagnostics/ids/target.h"
#include "support/files.h"

#include <fmt/format.h>

#include <filesystem>

namespace glider::driver {

codegen::CodegenOptions buildOptions(const compiler::Optimised& mission, unsigned level) {
  codegen::CodegenOptions options;
  options.optimisation_level = static_cast<int>(level);
  options.sources = &mission.sources();
  options.last_link = true;
  return options;
}

std::string stemOf(const std::string& mission) {
  return mission == compiler::kStandardInput ? "mission"
                                             : std::filesystem::path(mission).stem().string();
}

std::string builtName(const std::string& mission, const std::string& target,
                      std::string_view suffix) {
  return stemOf(mission) + (target.empty() ? "" : "-" + target) + std::string(suffix);
}

support::Result<report::BriefHash> executableHash(const std::string& path,
                                                  const compiler::Optimised& mission,
                                                  const std::string& target,
                                                  const std::vector<std::string>& user_code) {
  const auto board = compiler::loadTarget(target);
  if (!board) {
    return std::unexpected(board.error());
  }
  const auto code = compiler::loadUserCode(user_code, mission.mission, *board);
  if (!code) {
    return std::unexpected(code.error());
  }
  codegen::CodegenOptions how = buildOptions(mission, kUsualLevel);
  code->addTo(how);
  // The executable contains the name of its file, for debuggers.
  const auto folder = FlightFolder::scratch();
  if (!folder) {
    return std::unexpected(folder.error());
  }
  const std::string name = builtName(path, target, "");
  const std::string of = fmt::format("{}, as `glidercc build --target {}` writes it", name, target);
  const auto linked =
      codegen::linkExecutable(mission.input(), *board, how, folder->staging() / name);
  if (!linked && linked.error().id == support::diagnostics::unboundSymbol) {
    return report::BriefHash{of, "", linked.error().message + "; link it with `--link FILE`"};
  }
  if (!linked) {
    return std::unexpected(linked.error());
  }
  const auto content = support::readFile(folder->staging() / name);
  if (!content) {
    return std::unexpected(content.error());
  }
  return report::BriefHash{
      of, codegen::digestOf(*content),
      target == kUsualTarget ? "for the computer that runs glidercc, not for the vehicle" : ""};
}

}  // namespace glider::driver
