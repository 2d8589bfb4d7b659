// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/completion/completion.h"

#include "driver/exit_code.h"
#include "driver/terminal.h"

#include <memory>

namespace glider::driver {
namespace {

Completed completedOf(const CLI::Option& option) {
  Completed one;
  for (const std::string& name : option.get_lnames()) {
    one.names.push_back("--" + name);
  }
  for (const std::string& name : option.get_snames()) {
    one.names.push_back("-" + name);
  }
  one.description = option.get_description();
  if (option.get_items_expected_max() > 0) {
    one.word = valueWord(option);
    one.value = kindOf(option);
  }
  one.repeated = option.get_items_expected_max() > 1 ||
                 option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  return one;
}

int print(const CLI::App& app, const std::string& shell) {
  const std::vector<CompletedCommand> commands = completedCommands(app);
  const auto printed = printOut(shell == "bash"  ? bashCompletion(commands)
                                : shell == "zsh" ? zshCompletion(commands)
                                                 : fishCompletion(commands));
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

std::vector<CompletedCommand> completedCommands(const CLI::App& app) {
  std::vector<CompletedCommand> commands;
  for (const CLI::App* command : app.get_subcommands({})) {
    CompletedCommand one{command->get_name(), command->get_description(), {}, {}};
    for (const CLI::Option* option : command->get_options()) {
      if (!option->get_group().empty()) {
        (option->nonpositional() ? one.options : one.arguments).push_back(completedOf(*option));
      }
    }
    commands.push_back(std::move(one));
  }
  for (CompletedCommand& command : commands) {
    if (command.name == "help") {  // its argument is the name of a command
      for (const CompletedCommand& other : commands) {
        command.arguments.front().value.choices.push_back(other.name);
      }
    }
  }
  return commands;
}

void addCompletionCommand(CLI::App& app, int& status) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("completion", "Print a script that completes the command line in a shell");
  command->add_option("SHELL", *shell, "The shell: bash, zsh or fish")
      ->check(oneOf({"bash", "zsh", "fish"}))
      ->required();
  command->footer(
      "For this session: eval \"$(glidercc completion bash)\", or glidercc completion fish | "
      "source.\n"
      "For all: write it to ~/.local/share/bash-completion/completions/glidercc, to a file\n"
      "_glidercc in a folder of zsh's fpath, or to ~/.config/fish/completions/glidercc.fish.");
  command->callback([&app, shell, &status] { status = print(app, *shell); });
}

}  // namespace glider::driver
