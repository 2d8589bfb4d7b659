// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/boards.h"
#include "compiler/share.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/terminal.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>
#include <utility>

namespace glider::driver {
namespace {

int listTargets(Json* document) {
  std::string text;
  Json targets = Json::array();
  for (const std::string& name : compiler::targetNames()) {
    const auto board = compiler::loadTarget(name);
    if (!board) {
      return reportFailure(board.error());
    }
    text += fmt::format("{:<10} {}\n", name, board->description);
    targets.push_back({{"name", name}, {"description", board->description}});
  }
  if (document != nullptr) {
    (*document)["targets"] = std::move(targets);
    return kFine;
  }
  const auto printed = printOut(text);
  return printed ? kFine : reportFailure(printed.error());
}

/// True if the board's programs use the C library of the host.
bool sharesLibrary(const platforms::Board& board) {
  return !board.link.dynamic_linker.empty();
}

/// The flags with which clang compiles a mission's C and C++ for `board`.
std::string compilerFlags(const platforms::Board& board) {
  // The headers of the board's own C library; the host's would be wrong.
  const std::string library =
      sharesLibrary(board)
          ? ""
          : fmt::format("-nostdlibinc -isystem {} ", (board.folder / "include").string());
  return fmt::format(
      "--target={} {} -O2 -ffreestanding {}-ffp-contract=off -ffunction-sections -fdata-sections "
      "-fno-stack-protector -fno-exceptions -fno-rtti -fno-threadsafe-statics -I{}\n",
      board.triple, fmt::join(board.clang_flags, " "), library,
      (compiler::shareDirectory() / "c").string());
}

/// The flags with which clang links a mission in C for `board`, given after its objects.
std::string linkerFlags(const platforms::Board& board) {
  const auto files = [&board](std::vector<std::string> names) {
    for (std::string& name : names) {
      name = (board.folder / name).string();
    }
    return fmt::to_string(fmt::join(names, " "));
  };
  if (sharesLibrary(board)) {  // clang knows the rest of the host
    return files({"libglider.a", "libserialport.a"}) + " -lm\n";
  }
  std::string options = "-Wl,--gc-sections";
  for (const std::string& option : board.link.options) {
    options += "," + option;
  }
  return fmt::format("--target={} -fuse-ld=lld -static -nostdlib {} {} {} {}\n", board.triple,
                     options, files(board.link.before), files({"libglider.a"}),
                     files(board.link.after));
}

/// Prints the `flags` of the target `name`.
int printFlags(const std::string& name, std::string (*flags)(const platforms::Board&)) {
  const auto board = compiler::loadTarget(name);
  if (!board) {
    return reportFailure(board.error());
  }
  const auto printed = printOut(flags(*board));
  return printed ? kFine : reportFailure(printed.error());
}

struct TargetsOptions {
  bool json = false;
  std::string compile_for;
  std::string link_for;
};

int runTargets(const TargetsOptions& options) {
  if (!options.compile_for.empty()) {
    return printFlags(options.compile_for, compilerFlags);
  }
  return options.link_for.empty() ? inFormat(options.json, "targets", listTargets)
                                  : printFlags(options.link_for, linkerFlags);
}

}  // namespace

void addTargetsCommand(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("targets", "List the computers that missions can be built for");
  auto options = std::make_shared<TargetsOptions>();
  CLI::Option* compile =
      command
          ->add_option("--cflags", options->compile_for,
                       "Print the clang flags for compiling a mission's C or C++ code for a target")
          ->option_text("TARGET");
  command
      ->add_option("--libs", options->link_for,
                   "Print the clang linker arguments for a mission in C for a target; put them "
                   "after its objects")
      ->option_text("TARGET")
      ->excludes(compile);
  addFormatOption(*command, options->json);
  command->get_option("--format")->excludes("--cflags", "--libs");
  command->callback([options, &status] { status = runTargets(*options); });
}

}  // namespace glider::driver
