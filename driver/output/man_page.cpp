// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/man_page.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace glider::driver {
namespace {

/// `text` escaped for roff: dashes stay dashes, and no line begins with a control character.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool at_start = result.empty() || result.back() == '\n';
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if (c == '`') {
      result += "\\(ga";
    } else if (at_start && (c == '.' || c == '\'')) {
      result += std::string("\\&") + c;
    } else {
      result += c;
    }
  }
  return result;
}

/// One option, or a positional argument, as an entry of a list.
void addOption(std::string& page, const CLI::Option& option, const CLI::Formatter& words) {
  const bool positional = !option.nonpositional();
  page += fmt::format(
      ".TP\n\\fB{}\\fR{}\n{}\n", escaped(words.make_option_name(&option, positional)),
      escaped(words.make_option_opts(&option)), escaped(words.make_option_desc(&option)));
}

/// First the positional arguments, then the options.
void addOptions(std::string& page, const CLI::App& command, const CLI::Formatter& words) {
  for (const bool positional : {true, false}) {
    for (const CLI::Option* option : command.get_options()) {
      if (option->nonpositional() != positional) {
        addOption(page, *option, words);
      }
    }
  }
}

void addCommand(std::string& page, const CLI::App& command, const CLI::Formatter& words) {
  page += fmt::format(".SS glidercc {}\n{}.\n", escaped(command.get_name()),
                      escaped(command.get_description()));
  addOptions(page, command, words);
}

constexpr const char* kFiles =
    ".SH FILES\n.TP\n.I share/glidercc\nnext to the folder of the program: boards, platforms, the "
    "library, scenarios.\n"
    ".SH ENVIRONMENT\n.TP\n.B GLIDERCC_SHARE\nthe folder to use instead of "
    "share/glidercc.\n.TP\n.B "
    "NO_COLOR\nif set, messages have no colours.\n"
    ".SH SEE ALSO\n.BR glidercc\\-runtime (3),\n.BR clang (1)\n";

}  // namespace

std::string manPage(const CLI::App& app, const CLI::Formatter& words) {
  std::string page = fmt::format(
      ".\\\" SPDX-FileCopyrightText: 2026 The glidercc authors\n"
      ".\\\" SPDX-License-Identifier: Apache-2.0\n"
      ".TH GLIDERCC 1 \"\" \"glidercc {0}\" \"User Commands\"\n"
      ".SH NAME\nglidercc \\- missions for underwater gliders: check, compile, fly\n"
      ".SH SYNOPSIS\n.B glidercc\n.I COMMAND\n[\\fIOPTIONS\\fR]\n"
      ".SH DESCRIPTION\n{1}\n.SH OPTIONS\n",
      GLIDER_VERSION, escaped(app.get_description()));
  addOptions(page, app, words);
  page += ".SH COMMANDS\n";
  for (const CLI::App* command : app.get_subcommands({})) {
    addCommand(page, *command, words);
  }
  return page +
         ".SH EXIT STATUS\n0 success; 1 the mission has errors, or its flight ended with a "
         "warning; 2 usage error, or a file, port or tool failed.\n" +
         kFiles;
}

}  // namespace glider::driver
