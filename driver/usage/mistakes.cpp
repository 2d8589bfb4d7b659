// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/mistakes.h"

#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/terminal.h"
#include "frontend/spelling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace glider::driver {
namespace {

struct Complaint {
  std::string message, hint;
};

int tellComplaint(const Complaint& complaint) {
  tell(fmt::format("glidercc: error: {}\n  hint: {}\n", complaint.message, complaint.hint));
  return kWorldFailed;
}

/// Whether a command line that cannot be read asks for JSON.
bool wantsJson(const std::vector<std::string>& words) {
  const auto format = std::ranges::find(words, "--format");
  const bool apart =
      format != words.end() && std::next(format) != words.end() && *std::next(format) == "json";
  return apart || std::ranges::find(words, "--format=json") != words.end();
}

/// The command that was being read; `app` itself before any.
const CLI::App& commandOf(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : *parsed.front();
}

/// "glidercc check".
std::string nameOf(const CLI::App& command) {
  return command.get_parent() == nullptr ? command.get_name() : "glidercc " + command.get_name();
}

std::string helpHint(const CLI::App& command) {
  return fmt::format("`{} --help` lists what it takes", nameOf(command));
}

/// The names of its options as they are written, such as --format and -o.
std::vector<std::string> optionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) {
      continue;
    }
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
    for (const std::string& name : option->get_snames()) {
      names.push_back("-" + name);
    }
  }
  return names;
}

/// The option that the writer of `word` most likely meant; empty if none is near.
std::string nearestOption(const CLI::App& command, const std::string& word) {
  const std::vector<std::string> names = optionsOf(command);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  // What distinguishes names begins behind their dashes, which would count as letters that agree.
  std::vector<std::string_view> bare;
  for (const std::string_view name : candidates) {
    bare.push_back(name.substr(name.find_first_not_of('-')));
  }
  const size_t begin = word.find_first_not_of('-');
  const std::string_view wanted =
      begin == std::string::npos ? std::string_view() : std::string_view(word).substr(begin);
  const auto found = std::ranges::find(bare, frontend::closest(wanted, bare));
  return found == bare.end() ? "" : names[static_cast<size_t>(found - bare.begin())];
}

/// Whether `word` gives the vehicle's mission file to a command that takes it from a scenario.
bool isScenariosSkeleton(const CLI::App& command, std::string_view word) {
  return (word == "--mi" || word == "--skeleton") &&
         command.get_option_no_throw("--scenario") != nullptr;
}

/// Of the first word that no option and no argument took.
Complaint unexpected(const CLI::App& command, const std::string& given) {
  const std::string word = given.substr(0, given.find('='));
  if (!word.starts_with('-')) {
    return {fmt::format("`{}` takes no argument `{}`", nameOf(command), given), helpHint(command)};
  }
  if (isScenariosSkeleton(command, word)) {
    return {fmt::format("`{}` has no option `{}`", nameOf(command), word),
            "the scenario names the vehicle's mission file: copy one of `scenarios/`, set "
            "`skeleton = \"my.mi\"` in it, and give the copy with `--scenario`"};
  }
  const std::string near = nearestOption(command, word);
  return {fmt::format("`{}` has no option `{}`{}", nameOf(command), word,
                      near.empty() ? "" : fmt::format("; did you mean `{}`?", near)),
          helpHint(command)};
}

Complaint unknownCommand(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  const std::string_view near =
      frontend::closest(word, std::vector<std::string_view>(names.begin(), names.end()));
  return {fmt::format("there is no command `{}`{}", word,
                      near.empty() ? "" : fmt::format("; did you mean `{}`?", near)),
          fmt::format("the commands are: {}", fmt::join(names, ", "))};
}

/// `words`: the command line without the program.
Complaint complaintOf(const CLI::App& app, const std::vector<std::string>& words,
                      const CLI::ParseError& error) {
  const CLI::App& command = commandOf(app);
  const bool lacks = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (lacks && &command == &app && !words.front().starts_with('-')) {
    return unknownCommand(app, words.front());
  }
  const std::vector<std::string> left = app.remaining(true);
  const auto option = std::ranges::find_if(
      left, [](const std::string& word) { return word.size() > 1 && word[0] == '-'; });
  if (option != left.end()) {
    return unexpected(command, *option);  // also if it hides what the error says is missing
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !left.empty()) {
    return unexpected(command, left.front());
  }
  // CLI11 begins with the name of the option, which is empty for one that --help hides.
  const std::string what = error.what();
  return {what.starts_with(": ") ? what.substr(2) : what, helpHint(command)};
}

}  // namespace

int tellUnknownCommand(const CLI::App& app, const std::string& word) {
  return tellComplaint(unknownCommand(app, word));
}

int tellMistake(const CLI::App& app, int argc, char** argv, const CLI::ParseError& error) {
  if (argc < 2) {
    tell(app.help());
    return kWorldFailed;
  }
  const std::vector<std::string> words(argv + 1, argv + argc);
  const Complaint complaint = complaintOf(app, words, error);
  if (wantsJson(words)) {
    printUsageError(commandOf(app).get_name(), complaint.message, complaint.hint);
  }
  return tellComplaint(complaint);
}

}  // namespace glider::driver
