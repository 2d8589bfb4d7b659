// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/symbols/descriptions.h"

#include "support/one_line.h"

#include <algorithm>
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

/// The text of a line that is a comment; empty if it is not one.
std::string_view commentOf(std::string_view line) {
  line = trimmed(line);
  const bool comment = line.starts_with('#') || line.starts_with("//");
  const size_t begin = line.find_first_not_of("#/");
  return comment && begin != std::string_view::npos ? trimmed(line.substr(begin))
                                                    : std::string_view();
}

/// The line before offset `end`, which is the start of a line; moves `end` to the start of the
/// returned one.
std::string_view lineBefore(std::string_view text, size_t& end) {
  const size_t last = end - 1;
  const size_t newline = last == 0 ? std::string_view::npos : text.rfind('\n', last - 1);
  end = newline == std::string_view::npos ? 0 : newline + 1;
  return text.substr(end, last - end);
}

/// The comment above what begins at `begin`, if that begins its line. Reads only the lines of the
/// comment and one more: a file may be one long line with many declarations.
std::string commentAbove(std::string_view text, size_t begin) {
  constexpr int kMostLines = 8;
  while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) {
    --begin;
  }
  std::string all;
  for (int i = 0; i < kMostLines && begin > 0 && text[begin - 1] == '\n'; ++i) {
    const std::string_view comment = commentOf(lineBefore(text, begin));
    if (comment.empty() || comment.starts_with("SPDX-")) {
      break;
    }
    all = std::string(comment) + (all.empty() ? "" : " ") + all;
  }
  return all;
}

std::string_view commentBehind(std::string_view text, size_t end) {
  const std::string_view rest =
      text.substr(std::min(text.find_first_not_of(" \t", end), text.size()));
  const bool comment = rest.starts_with('#') || rest.starts_with("//");
  return comment ? commentOf(rest.substr(0, rest.find('\n'))) : std::string_view();
}

/// The declaration without comments and line breaks, shortened.
std::string shortened(std::string_view text) {
  constexpr size_t kLongest = 100;
  constexpr size_t kMostRead = 1000;
  const std::string out = support::onOneLine(text.substr(0, kMostRead));
  return out.size() > kLongest ? out.substr(0, kLongest) + "…" : out;
}

}  // namespace

std::string describe(const support::SourceManager& sources, const support::SourceRange& where) {
  const std::string_view text = sources.text(where.file);
  if (const std::string_view behind = commentBehind(text, where.end); !behind.empty()) {
    return std::string(behind);
  }
  const std::string above = commentAbove(text, where.begin);
  return above.empty() ? shortened(sources.text(where)) : above;
}

}  // namespace glider::frontend
