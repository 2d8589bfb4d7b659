// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/help.h"

#include "driver/exit_code.h"
#include "driver/terminal.h"
#include "driver/usage/mistakes.h"
#include "driver/usage/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace glider::driver {
namespace {

struct Example {
  std::string_view command;
  std::string_view line;  ///< what follows "glidercc "
};

/// Two for each command. A test runs them in a folder with the files that they name.
constexpr Example kExamples[] = {
#define EXAMPLE(command, line) {#command, line},
#include "driver/usage/examples.def"
#undef EXAMPLE
};

int help(const CLI::App& app, const std::string& word) {
  const auto all = app.get_subcommands({});
  const auto command = std::ranges::find(all, word, &CLI::App::get_name);
  if (!word.empty() && command == all.end()) {
    return tellUnknownCommand(app, word);
  }
  const auto printed = printOut(helpOf(word.empty() ? app : **command));
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  const std::string choices = unnamedChoices(*option);
  const std::string& description = option->get_description();
  return choices.empty() ? description : fmt::format("{}; one of {}", description, choices);
}

std::string HelpFormatter::make_footer(const CLI::App* app) const {
  std::string lines;
  for (const Example& example : kExamples) {
    if (example.command == app->get_name()) {
      lines += fmt::format("  glidercc {}\n", example.line);
    }
  }
  const std::string own = CLI::Formatter::make_footer(app);
  return own + (lines.empty() ? "Try: glidercc new transect, or glidercc check FILE.mission\n"
                                "Of each command: glidercc help COMMAND\n"
                              : "\nExamples:\n" + lines);
}

std::string helpOf(const CLI::App& command) {
  // App::help would show that of the command that was read.
  const std::string name =
      command.get_parent() == nullptr ? command.get_name() : "glidercc " + command.get_name();
  return command.get_formatter()->make_help(&command, name, CLI::AppFormatMode::Normal);
}

void addHelpCommand(CLI::App& app, int& status) {
  auto word = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("help", "Show the help of a command");
  command->add_option("COMMAND", *word, "The command [the list of all]");
  command->callback([&app, word, &status] { status = help(app, *word); });
}

}  // namespace glider::driver
