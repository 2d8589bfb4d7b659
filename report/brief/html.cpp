// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/brief/html.h"

#include "report/svg/text_lines.h"

#include <algorithm>

namespace glider::report::html {

std::string raw(std::string_view text) {
  return toXml(text);
}

std::string words(std::string_view text) {
  std::string out;
  bool code = false;
  for (size_t end = text.find('`'); end != std::string_view::npos; end = text.find('`')) {
    const bool closed = code || text.find('`', end + 1) != std::string_view::npos;
    out += toXml(text.substr(0, end));
    out += !closed ? "`" : code ? "</code>" : "<code>";
    code = closed && !code;
    text.remove_prefix(end + 1);
  }
  return out + toXml(text);
}

std::string cell(std::string_view text) {
  return text.empty() ? "" : "<code>" + raw(text) + "</code>";
}

std::string table(const std::vector<std::string>& heads,
                  const std::vector<std::vector<std::string>>& rows) {
  const auto used = [&](size_t column) {
    return std::ranges::any_of(rows, [&](const auto& row) { return !row[column].empty(); });
  };
  std::string out = "<table>\n<thead><tr>";
  for (size_t i = 0; i < heads.size(); ++i) {
    out += used(i) ? "<th>" + heads[i] + "</th>" : "";
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    out += "<tr>";
    for (size_t i = 0; i < heads.size(); ++i) {
      out += used(i) ? "<td>" + row[i] + "</td>" : "";
    }
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n";
}

}  // namespace glider::report::html
