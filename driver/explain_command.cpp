// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/output/explain_page.h"
#include "driver/terminal.h"
#include "frontend/spelling.h"
#include "support/diagnostics/diagnostic.h"
#include "support/diagnostics/ids/command.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace glider::driver {
namespace {

using support::CatalogueRow;
using support::Result;

/// The number in "GL2003", "gl2003" or "2003"; -1 if `word` is not one.
int numberOf(std::string_view word) {
  constexpr size_t kDigits = 4;
  if (word.starts_with("GL") || word.starts_with("gl")) {
    word.remove_prefix(2);
  }
  const bool number = word.size() == kDigits &&
                      std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
  return number ? std::atoi(std::string(word).c_str()) : -1;
}

/// "`GL2003 unknown-name` and `GL2004 …`": those with the nearest numbers, or the nearest name.
std::string nearest(std::string_view word) {
  std::vector<CatalogueRow> rows = support::catalogue();
  if (const int number = numberOf(word); number >= 0) {
    auto distance = [number](const CatalogueRow& row) {
      return std::abs(static_cast<int>(row.id) - number);
    };
    std::ranges::stable_sort(rows, {}, distance);
  } else {
    auto distance = [word](const CatalogueRow& row) {
      return frontend::editDistance(word, row.slug);
    };
    std::ranges::stable_sort(rows, {}, distance);
  }
  return fmt::format("`{} {}` and `{} {}`", support::code(rows[0].id), rows[0].slug,
                     support::code(rows[1].id), rows[1].slug);
}

Result<std::string> pageFor(const std::string& word) {
  const int number = numberOf(word);
  const auto row = std::ranges::find_if(support::catalogue(), [&](const CatalogueRow& r) {
    return static_cast<int>(r.id) == number || r.slug == word;
  });
  if (row == support::catalogue().end()) {
    constexpr size_t kLongestShown = 60;  // for longer words the nearest name does not help
    return support::fail(support::diagnostics::unknownDiagnostic, word.substr(0, kLongestShown),
                         nearest(word.substr(0, kLongestShown)));
  }
  return explainPage(row->id);
}

/// One line for each diagnostic: id, name, title.
Result<std::string> index() {
  std::vector<CatalogueRow> rows = support::catalogue();
  std::ranges::sort(rows, {}, &CatalogueRow::id);
  std::string out;
  for (const CatalogueRow& row : rows) {
    const auto page = explainPage(row.id);
    if (!page) {
      return page;
    }
    const std::string_view heading = std::string_view(*page).substr(0, page->find('\n'));
    const size_t colon = heading.find(": ");
    const std::string_view title =
        colon == std::string_view::npos ? heading : heading.substr(colon + 2);
    out += fmt::format("{}  {:<28}  {}\n", support::code(row.id), row.slug, title);
  }
  return out;
}

int explain(const std::string& word) {
  const auto text = word.empty() ? index() : pageFor(word);
  if (!text) {
    return reportFailure(text.error());
  }
  const auto printed = printOut(*text);
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

void addExplainCommand(CLI::App& app, int& status) {
  auto word = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("explain", "Explain a diagnostic: the rule, an example and how to fix it");
  command->add_option(
      "ID", *word, "Number or name of the diagnostic, such as GL2007 or types-differ [list all]");
  command->callback([word, &status] { status = explain(*word); });
}

}  // namespace glider::driver
