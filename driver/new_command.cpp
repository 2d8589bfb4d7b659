// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/share.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/output/executable.h"
#include "driver/terminal.h"
#include "driver/usage/values.h"
#include "support/diagnostics/ids/files.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace glider::driver {
namespace {

using support::Result;

struct NewOptions {
  std::string name;    ///< of the template; empty: list them
  std::string output;  ///< empty: named after the template
};

std::filesystem::path folderOfTemplates() {
  return compiler::shareDirectory() / "templates";
}

std::vector<std::string> templateNames() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folderOfTemplates(), ignored)) {
    if (entry.path().extension() == ".mission") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

Result<std::string> readTemplate(const std::string& name) {
  return support::readFile(folderOfTemplates() / (name + ".mission"));
}

/// The text without the lines of its licence, which are not the pilot's: it begins with the comment
/// that says what the mission does.
std::string withoutLicence(const std::string& text) {
  const size_t blank = text.find("\n\n");
  return text.starts_with("# SPDX") && blank != std::string::npos ? text.substr(blank + 2) : text;
}

/// What the mission does: the first sentence of its comment.
std::string descriptionOf(const std::string& text) {
  std::string words;
  for (const char c : withoutLicence(text)) {
    if (c == '.') {
      break;
    }
    words += c == '\n' ? ' ' : c;
  }
  words.erase(std::remove(words.begin(), words.end(), '#'), words.end());
  std::string single;  // a line break in the comment leaves two spaces
  std::ranges::unique_copy(words, std::back_inserter(single),
                           [](char a, char b) { return a == ' ' && b == ' '; });
  return single.starts_with(' ') ? single.substr(1) : single;
}

Result<std::string> list() {
  std::string text;
  for (const std::string& name : templateNames()) {
    const auto content = readTemplate(name);
    if (!content) {
      return content;
    }
    text += fmt::format("{:<17} {}\n", name, descriptionOf(*content));
  }
  return text;
}

/// Whether `word` can be the name of a mission.
bool isName(const std::string& word) {
  const auto letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) != 0 &&
         std::ranges::all_of(word, letter);
}

/// The mission called as its file, if that is a name.
std::string namedAfter(std::string text, const std::string& name, const std::string& file) {
  const std::string line = "\nmission " + name + "\n";
  const std::string stem = stemOf(file);
  const size_t at = text.find(line);
  if (file != "-" && isName(stem) && at != std::string::npos) {
    text.replace(at, line.size(), "\nmission " + stem + "\n");
  }
  return text;
}

Result<void> write(const NewOptions& options) {
  const auto content = readTemplate(options.name);
  if (!content) {
    return std::unexpected(content.error());
  }
  const std::string file = options.output.empty() ? options.name + ".mission" : options.output;
  const std::string text = namedAfter(withoutLicence(*content), options.name, file);
  if (file == "-") {
    return printOut(text);
  }
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) {
    return support::fail(support::diagnostics::cannotWrite, file, std::strerror(EEXIST));
  }
  if (auto written = support::writeFileAtomically(file, text); !written) {
    return written;
  }
  return printSuccess(
      fmt::format("{0}: {1}\nnext: glidercc check {0}\n", file, descriptionOf(*content)));
}

int make(const NewOptions& options) {
  if (options.name.empty()) {
    const auto text = list();
    const auto printed = text ? printOut(*text) : std::unexpected(text.error());
    return printed ? kFine : reportFailure(printed.error());
  }
  const auto done = write(options);
  return done ? kFine : reportFailure(done.error());
}

}  // namespace

void addNewCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<NewOptions>();
  CLI::App* command =
      app.add_subcommand("new", "Write a commented mission to begin from, or list the templates");
  command->add_option("TEMPLATE", options->name, "What the mission does [list all]")
      ->check(oneOf(templateNames()));
  command->add_option("FILE", options->output,
                      "Output file, which must not exist; `-` is standard output "
                      "[TEMPLATE.mission]");
  command->callback([options, &status] { status = make(*options); });
}

}  // namespace glider::driver
