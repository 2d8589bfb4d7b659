// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/completion/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace glider::driver {
namespace {

std::string inQuotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' || c == '\\' ? "\\" : "";
    result += c;
  }
  return result + "'";
}

/// The options of `complete` for a value.
std::string valueOf(const ValueKind& value) {
  std::string words = fmt::format("{}", fmt::join(value.choices, " "));
  for (const std::string& suffix : value.suffixes) {
    words += (words.empty() ? "(" : " (") + ("__fish_complete_suffix " + suffix) + ")";
  }
  if (value.folder) {
    words = "(__fish_complete_directories)";
  }
  if (value.file && value.suffixes.empty()) {
    return words.empty() ? " -r -F" : " -r -F -a " + inQuotes(words);
  }
  return words.empty() ? " -x" : " -x -a " + inQuotes(words);
}

std::string linesOf(const CompletedCommand& command) {
  const std::string begin =
      fmt::format("complete -c glidercc -n '__fish_seen_subcommand_from {}'", command.name);
  std::string lines;
  for (const Completed& option : command.options) {
    lines += begin;
    for (const std::string& name : option.names) {
      lines += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    lines += (option.word.empty() ? "" : valueOf(option.value)) + " -d " +
             inQuotes(option.description) + "\n";
  }
  for (const Completed& argument : command.arguments) {
    const std::string value = valueOf(argument.value);
    if (value != " -x") {
      lines += begin + (value.starts_with(" -x") ? value.substr(3) : " -F") + "\n";
    }
  }
  return lines;
}

}  // namespace

std::string fishCompletion(const std::vector<CompletedCommand>& commands) {
  std::string text =
      "# Completes glidercc in fish; written by `glidercc completion fish`.\ncomplete -c glidercc "
      "-f\n"
      "complete -c glidercc -n __fish_use_subcommand -l version -d 'Print the version'\n";
  for (const CompletedCommand& command : commands) {
    text += fmt::format("complete -c glidercc -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        inQuotes(command.description));
  }
  for (const CompletedCommand& command : commands) {
    text += linesOf(command);
  }
  return text;
}

}  // namespace glider::driver
