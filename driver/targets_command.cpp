// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/boards.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/share.h"
#include "driver/terminal.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>

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

/// What makes clang compile a mission's C and C++ for `name`.
int printFlags(const std::string& name) {
  const auto board = loadTarget(name);
  if (!board) {
    return reportFailure(board.error());
  }
  // A board's C library is linked, but its headers are not here, and this machine's are wrong.
  const bool own_library = !board->link.dynamic_linker.empty();
  const auto printed = printOut(fmt::format(
      "--target={} {} -O2 -ffreestanding {}-ffp-contract=off -ffunction-sections -fdata-sections "
      "-fno-stack-protector -fno-exceptions -fno-rtti -fno-threadsafe-statics -I{}\n",
      board->triple, fmt::join(board->clang_flags, " "), own_library ? "" : "-nostdlibinc ",
      (shareDirectory() / "c").string()));
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

void addTargetsCommand(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("targets", "List the computers that missions can be built for");
  auto board = std::make_shared<std::string>();
  command
      ->add_option("--cflags", *board,
                   "Print the flags with which clang compiles a mission's C or C++ for a target")
      ->option_text("TARGET");
  command->callback(
      [board, &status] { status = board->empty() ? listTargets() : printFlags(*board); });
}

}  // namespace glider::driver
