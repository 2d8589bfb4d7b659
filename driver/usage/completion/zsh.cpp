// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/completion/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace glider::driver {
namespace {

/// `text` within single quotes, where `special` and brackets have no meaning of their own.
std::string escaped(const std::string& text, std::string_view special) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += special.find(c) == std::string_view::npos ? "" : "\\";
      result += c;
    }
  }
  return result;
}

/// What completes a value: `(a b)`, or a call.
std::string actionFor(const ValueKind& value) {
  std::vector<std::string> patterns;
  for (const std::string& suffix : value.suffixes) {
    patterns.push_back("*" + suffix);
  }
  const std::string files =
      value.suffixes.empty() ? "_files" : fmt::format("_files -g \"{}\"", fmt::join(patterns, " "));
  const std::string words = fmt::format("{}", fmt::join(value.choices, " "));
  return !value.choices.empty() && value.file
             ? fmt::format("_alternative \"words:name:({})\" \"files:file:{}\"", words,
                           escaped(files, "\""))
         : !value.choices.empty() ? fmt::format("({})", words)
         : value.file             ? files
         : value.folder           ? "_files -/"
                                  : " ";
}

std::string optionOf(const Completed& option) {
  std::string lines;
  for (const std::string& name : option.names) {
    const bool value = !option.word.empty();
    lines += fmt::format(
        "        '{}{}{}[{}]{}' \\\n", option.repeated ? "*" : "", name,
        !value                   ? ""
        : name.starts_with("--") ? "="
                                 : "+",
        escaped(option.description, "[]:"),
        value ? fmt::format(":{}:{}", escaped(option.word, ":"), actionFor(option.value)) : "");
  }
  return lines;
}

std::string caseOf(const CompletedCommand& command) {
  std::string lines;
  for (const Completed& option : command.options) {
    lines += optionOf(option);
  }
  for (const Completed& argument : command.arguments) {
    lines += fmt::format("        '{}:{}:{}' \\\n", argument.repeated ? "*" : "", argument.word,
                         actionFor(argument.value));
  }
  return fmt::format("    {})\n      _arguments -s \\\n{}        && return ;;\n", command.name,
                     lines);
}

}  // namespace

std::string zshCompletion(const std::vector<CompletedCommand>& commands) {
  std::string names;
  std::string cases;
  for (const CompletedCommand& command : commands) {
    names += fmt::format("    '{}:{}'\n", command.name, escaped(command.description, ":"));
    cases += caseOf(command);
  }
  return fmt::format(
      "#compdef glidercc\n# Completes glidercc in zsh; written by `glidercc completion zsh`.\n"
      "_glidercc() {{\n  local -a commands\n  commands=(\n{}  )\n  if ((CURRENT == 2)); then\n    "
      "_describe command commands\n    return\n  fi\n  local command=$words[2]\n  shift words\n  "
      "((CURRENT--))\n  case $command in\n{}  esac\n}}\n"
      "if [[ $funcstack[1] == _glidercc ]]; then\n  _glidercc \"$@\"\nelse\n  compdef _glidercc "
      "glidercc\nfi\n",
      names, cases);
}

}  // namespace glider::driver
