// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/svg/text_lines.h"

#include <algorithm>

namespace glider::report {
namespace {

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// The first `columns` characters.
std::string_view start(std::string_view text, size_t columns) {
  size_t at = 0;
  for (size_t seen = 0; at < text.size(); ++at) {
    seen += continues(text[at]) ? 0U : 1U;
    if (seen > columns) {
      break;
    }
  }
  return text.substr(0, at);
}

/// Where the first line of `text` ends: in its later half after an operator or comma, otherwise at
/// the last space, otherwise inside a word.
size_t lineEnd(std::string_view text, size_t columns) {
  const std::string_view fits = start(text, columns);
  if (fits.size() == text.size()) {
    return text.size();
  }
  size_t blank = std::string_view::npos;
  for (size_t i = fits.size(); i-- > fits.size() / 2;) {
    const bool here = text[i] == ' ' || (i + 1 == fits.size() && text[i + 1] == ' ');
    const std::string_view before = text.substr(0, text[i] == ' ' ? i : i + 1);
    if (here && (before.ends_with("&&") || before.ends_with("||") || before.ends_with(","))) {
      return before.size();
    }
    blank = here && blank == std::string_view::npos ? before.size() : blank;
  }
  return blank == std::string_view::npos ? fits.size() : blank;
}

/// The number of bytes of the UTF-8 character at the start of `text`; 0 if there is none.
size_t characterLength(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const size_t length = lead < 0x80                   ? 1
                        : lead >= 0xC2 && lead < 0xE0 ? 2
                        : lead >= 0xE0 && lead < 0xF0 ? 3
                        : lead >= 0xF0 && lead < 0xF5 ? 4
                                                      : 0;
  if (length == 0 || length > text.size() ||
      !std::ranges::all_of(text.substr(1, length - 1), continues)) {
    return 0;
  }
  return length;
}

}  // namespace

size_t columnsOf(std::string_view text) {
  return static_cast<size_t>(std::ranges::count_if(text, [](char c) { return !continues(c); }));
}

std::vector<std::string> wrap(std::string_view text, size_t columns, size_t most_lines) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    if (lines.size() + 1 == most_lines && columnsOf(text) > columns) {
      lines.push_back(std::string(start(text, columns - 1)) + "…");
      break;
    }
    const size_t end = lineEnd(text, columns);
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  }
  return lines;
}

std::string toXml(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const size_t length = characterLength(text);
    const char c = text[0];
    if (length == 0 || (length == 1 && ((c < ' ' && c != '\n' && c != '\t') || c == 0x7F))) {
      out += '?';
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<size_t>(length, 1));
  }
  return out;
}

}  // namespace glider::report
