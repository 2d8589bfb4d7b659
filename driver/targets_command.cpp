// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/boards.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/terminal.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace glider::driver {
namespace {

int listTargets() {
  std::string text;
  for (const std::string& name : targetNames()) {
    const auto board = loadTarget(name);
    if (!board) {
      return reportFailure(board.error());
    }
    text += fmt::format("{:<10} {}\n", name, board->description);
  }
  const auto printed = printOut(text);
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

void addTargetsCommand(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("targets", "List the computers that missions can be built for");
  command->callback([&status] { status = listTargets(); });
}

}  // namespace glider::driver
