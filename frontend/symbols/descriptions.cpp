// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/symbols/descriptions.h"

#include <string_view>

namespace glider::frontend {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f";

std::string_view trimmed(std::string_view text) {
  const size_t begin = text.find_first_not_of(kBlanks);
  return begin == std::string_view::npos
             ? std::string_view()
             : text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// What a line that is a comment says; empty if it is none.
std::string_view commentOf(std::string_view line) {
  line = trimmed(line);
  const bool comment = line.starts_with('#') || line.starts_with("//");
  const size_t begin = line.find_first_not_of("#/");
  return comment && begin != std::string_view::npos ? trimmed(line.substr(begin))
                                                    : std::string_view();
}

std::string commentAbove(const support::SourceManager& sources, const support::SourceRange& where) {
  constexpr uint32_t kMostLines = 8;
  const support::LineColumn place = sources.place(where.file, where.begin);
  const std::string_view before = sources.line(where.file, place.line).substr(0, place.column - 1);
  if (!trimmed(before).empty()) {
    return "";
  }
  std::string text;
  for (uint32_t line = place.line - 1; line > 0 && place.line - line <= kMostLines; --line) {
    const std::string_view comment = commentOf(sources.line(where.file, line));
    if (comment.empty() || comment.starts_with("SPDX-")) {
      break;
    }
    text = std::string(comment) + (text.empty() ? "" : " ") + text;
  }
  return text;
}

std::string_view commentBehind(const support::SourceManager& sources,
                               const support::SourceRange& where) {
  const std::string_view rest = std::string_view(sources.text(where.file)).substr(where.end);
  return commentOf(rest.substr(0, rest.find('\n')));
}

/// The declaration without comments and line breaks, shortened.
std::string onOneLine(std::string_view text) {
  constexpr size_t kLongest = 100;
  std::string out;
  bool comment = false;
  for (char c : text) {
    comment = c == '#' || (comment && c != '\n');
    const bool blank = comment || kBlanks.contains(c);
    if (!blank) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  return out.size() > kLongest ? out.substr(0, kLongest) + "…" : out;
}

}  // namespace

std::string describe(const support::SourceManager& sources, const support::SourceRange& where) {
  if (const std::string_view behind = commentBehind(sources, where); !behind.empty()) {
    return std::string(behind);
  }
  const std::string above = commentAbove(sources, where);
  return above.empty() ? onOneLine(sources.text(where)) : above;
}

}  // namespace glider::frontend
