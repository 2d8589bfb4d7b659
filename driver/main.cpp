// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/commands.h"
#include "driver/exit_code.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <string>

namespace {

constexpr const char* kFooter =
    "Exit codes: 0 fine, 1 the mission has errors (or its flight ended in an abort), 2 wrong usage "
    "or the world failed.\n"
    "Try: glidercc check missions/figure2.mission";

int run(int argc, char** argv) {
  using namespace glider::driver;
  CLI::App app{
      "glidercc: checks missions for underwater gliders, compiles them for the computer in the "
      "payload bay, and flies\n"
      "them in a simulator.",
      "glidercc"};
  app.set_version_flag("--version", std::string("glidercc ") + GLIDER_VERSION);
  app.require_subcommand(1);
  app.footer(kFooter);
  int status = kFine;
  addCheckCommand(app, status);
  addBuildCommand(app, status);
  addSimCommand(app, status);
  addFmtCommand(app, status);
  addFixCommand(app, status);
  addExplainCommand(app, status);
  addTargetsCommand(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kFine : kWorldFailed;
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that closes its pipe early shows as a failed write, not as a silent death.
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "glidercc: internal error: {}\n", error.what());
    return glider::driver::kWorldFailed;
  }
}
