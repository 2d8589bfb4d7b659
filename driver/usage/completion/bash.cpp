// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/completion/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace glider::driver {
namespace {

constexpr const char* kHead =
    R"(# Completes glidercc in bash; written by `glidercc completion bash`.
_glidercc_words() {
  COMPREPLY+=($(compgen -W "$1" -- "$cur"))
}
_glidercc_files() {  # of the endings given, or all; and folders
  local ending IFS=$'\n'
  compopt -o filenames
  if (($# == 0)); then
    COMPREPLY+=($(compgen -f -- "$cur"))
    return
  fi
  COMPREPLY+=($(compgen -d -- "$cur"))
  for ending; do
    COMPREPLY+=($(compgen -f -X "!*$ending" -- "$cur"))
  done
}
_glidercc() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}
  COMPREPLY=()
  if [[ $cur == = ]]; then  # --format=
    cur=
  elif [[ $prev == = ]]; then
    prev=${COMP_WORDS[COMP_CWORD-2]}
  fi
)";

/// The call that completes a value; empty: nothing is known of it.
std::string callFor(const ValueKind& value) {
  std::string calls;
  if (!value.choices.empty()) {
    calls = fmt::format("_glidercc_words \"{}\"", fmt::join(value.choices, " "));
  }
  if (value.file) {
    calls += fmt::format("{}_glidercc_files{}{}", calls.empty() ? "" : "; ",
                         value.suffixes.empty() ? "" : " ", fmt::join(value.suffixes, " "));
  } else if (value.folder) {
    calls = "_glidercc_files .";
  }
  return calls;
}

/// The cases of the options with values, and of what else a command takes.
std::string casesOf(const CompletedCommand& command) {
  std::string values;
  std::vector<std::string> names;
  for (const Completed& option : command.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (option.word.empty()) {
      continue;
    }
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) {
      patterns.push_back(fmt::format("\"{} {}\"", command.name, name));
    }
    const std::string call = callFor(option.value);
    values += fmt::format("    {}) {}return ;;\n", fmt::join(patterns, "|"),
                          call.empty() ? "" : call + "; ");
  }
  std::string arguments;
  for (const Completed& argument : command.arguments) {
    const std::string call = callFor(argument.value);
    arguments += call.empty() ? "" : " " + call + ";";
  }
  return values +
         fmt::format(
             "    \"{0} \"*) if [[ $cur == -* ]]; then _glidercc_words \"{1}\"; else{2} :; fi ;;\n",
             command.name, fmt::join(names, " "), arguments);
}

}  // namespace

std::string bashCompletion(const std::vector<CompletedCommand>& commands) {
  std::vector<std::string> names;
  std::string cases;
  for (const CompletedCommand& command : commands) {
    names.push_back(command.name);
    cases += casesOf(command);
  }
  return fmt::format(
      "{}  if ((COMP_CWORD == 1)); then\n    _glidercc_words \"{} --help --version\"\n    return\n "
      " "
      "fi\n  case \"$command $prev\" in\n{}  esac\n}}\ncomplete -F _glidercc glidercc\n",
      kHead, fmt::join(names, " "), cases);
}

}  // namespace glider::driver
