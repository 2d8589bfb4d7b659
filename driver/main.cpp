// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/output/man_page.h"
#include "driver/terminal.h"

#include <CLI/CLI.hpp>

#include <csignal>
#include <exception>
#include <string>

namespace {

constexpr const char* kFooter =
    "Exit codes: 0 success, 1 the mission has errors (or its flight ended with a warning),\n"
    "2 usage error, or a file, port or tool failed.\n"
    "Try: glidercc check FILE.mission";

/// Reports an unknown command by its name; CLI11 would only report that a command is required.
int tellUnknownCommand(const CLI::App& app, const std::string& word) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  glider::driver::tell("glidercc: error: there is no command `" + word +
                       "`\n  hint: the commands are: " + names + "\n");
  return glider::driver::kWorldFailed;
}

/// Prints what is wrong with the command line, or the help that it asks for; returns the exit code.
int tellUsage(const CLI::App& app, int argc, char** argv, const CLI::ParseError& error) {
  using namespace glider::driver;
  if (glider::campaign::launchOf().rank > 0) {
    return kFine;  // rank 0 has the same command line
  }
  const bool lacks = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (lacks && argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty()) {
    return tellUnknownCommand(app, argv[1]);
  }
  return app.exit(error) == 0 ? kFine : kWorldFailed;
}

int run(int argc, char** argv) {
  using namespace glider::driver;
  CLI::App app{
      "glidercc: checks missions for underwater gliders, compiles them for the computer in the "
      "payload bay, and flies\n"
      "them in a simulator.",
      "glidercc"};
  app.set_version_flag("--version", std::string("glidercc ") + GLIDER_VERSION);
  app.add_flag_callback(
      "--man", [&app] { throw CLI::CallForVersion(manPage(app), 0); },
      "Print the manual page (`glidercc --man | man -l -`) and exit");
  app.require_subcommand(1);
  app.footer(kFooter);
  int status = kFine;
  addCheckCommand(app, status);
  addDiffCommand(app, status);
  addBuildCommand(app, status);
  addParamsCommand(app, status);
  addGraphCommand(app, status);
  addBriefCommand(app, status);
  addSimCommand(app, status);
  addCampaignCommand(app, status);
  addLogCommand(app, status);
  addMiCommand(app, status);
  addFmtCommand(app, status);
  addFixCommand(app, status);
  addExplainCommand(app, status);
  addTargetsCommand(app, status);
  addPlatformCommand(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return tellUsage(app, argc, argv, error);
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that closes its pipe early then causes a failed write instead of ending the program
  // without a message.
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    glider::driver::tell(std::string("glidercc: internal error: ") + error.what() + "\n");
    return glider::driver::kWorldFailed;
  }
}
