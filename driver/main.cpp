// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/output/man_page.h"
#include "driver/output/version.h"
#include "driver/terminal.h"
#include "driver/usage/common_options.h"
#include "driver/usage/completion/completion.h"
#include "driver/usage/help.h"
#include "driver/usage/mistakes.h"

#include <CLI/CLI.hpp>

#include <csignal>
#include <exception>
#include <memory>
#include <string>

/// Read by jemalloc: what is freed is kept. A check frees most of what it uses and asks for as much
/// again, and each page that the system takes in between costs more than its contents.
extern "C" const char* malloc_conf;  // NOLINT(readability-identifier-naming)
const char* malloc_conf = "dirty_decay_ms:-1";

namespace {

constexpr const char* kFooter =
    "Exit codes: 0 success, 1 the mission has errors (or its flight ended with a warning),\n"
    "2 usage error, or a file, port or tool failed.";

/// Prints what is wrong with the command line, or the help that it asks for; returns the exit code.
int tellUsage(const CLI::App& app, int argc, char** argv, const CLI::ParseError& error) {
  using namespace glider::driver;
  if (glider::campaign::launchOf().rank > 0) {
    return kFine;  // rank 0 has the same command line
  }
  if (error.get_exit_code() != 0) {
    return tellMistake(app, argc, argv, error);
  }
  const CLI::App* command = app.get_subcommands().empty() ? &app : app.get_subcommands().front();
  const bool help = dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr;
  const auto printed = printOut(help ? helpOf(*command) : std::string(error.what()) + "\n");
  return printed ? kFine : reportFailure(printed.error());
}

int run(int argc, char** argv) {
  using namespace glider::driver;
  CLI::App app{
      "glidercc: checks missions for underwater gliders, compiles them for the computer in the "
      "payload bay, and flies\n"
      "them in a simulator.",
      "glidercc"};
  app.set_version_flag("--version", versionText);
  app.add_flag_callback(
      "--man", [&app] { throw CLI::CallForVersion(manPage(app, HelpFormatter()), 0); },
      "Print the manual page (`glidercc --man | man -l -`) and exit");
  app.require_subcommand(1);
  app.formatter(std::make_shared<HelpFormatter>());
  app.footer(kFooter);
  int status = kFine;
  addNewCommand(app, status);
  addCheckCommand(app, status);
  addDiffCommand(app, status);
  addBuildCommand(app, status);
  addParamsCommand(app, status);
  addPlanCommand(app, status);
  addGraphCommand(app, status);
  addBriefCommand(app, status);
  addSimCommand(app, status);
  addCampaignCommand(app, status);
  addDockCommand(app, status);
  addLogCommand(app, status);
  addMessagesCommand(app, status);
  addMiCommand(app, status);
  addFmtCommand(app, status);
  addFixCommand(app, status);
  addExplainCommand(app, status);
  addTargetsCommand(app, status);
  addPlatformCommand(app, status);
  addHelpCommand(app, status);
  addCompletionCommand(app, status);
  for (CLI::App* command : app.get_subcommands({})) {
    addCommonOptions(*command);
  }
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
