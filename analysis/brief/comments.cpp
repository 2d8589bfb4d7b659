// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/brief/written.h"

#include <algorithm>
#include <cctype>

namespace glider::analysis {
namespace {

constexpr std::string_view kSpace = " \t\r";

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(kSpace);
  return first == std::string_view::npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// The words of a comment; empty for a line of signs and for a licence.
std::string_view wordsOf(std::string_view comment) {
  const size_t first = comment.find_first_not_of("# \t\r");
  const std::string_view words =
      first == std::string_view::npos ? std::string_view() : trimmed(comment.substr(first));
  const bool says = std::ranges::any_of(
      words, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; });
  return !says || words.starts_with("SPDX-") ? std::string_view() : words;
}

void append(std::string& text, std::string_view words) {
  text += (text.empty() || words.empty() ? "" : " ") + std::string(words);
}

size_t lineBegin(std::string_view text, size_t at) {
  const size_t end = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return end == std::string_view::npos ? 0 : end + 1;
}

std::string_view lineAt(std::string_view text, size_t begin) {
  return text.substr(begin, text.find('\n', begin) - begin);
}

/// Where a line that is only a comment has its `#`; npos for another line.
size_t commentColumn(std::string_view line) {
  const size_t first = line.find_first_not_of(kSpace);
  return first != std::string_view::npos && line[first] == '#' ? first : std::string_view::npos;
}

}  // namespace

std::string commentAbove(std::string_view text, size_t begin) {
  size_t at = lineBegin(text, begin);
  const size_t column = lineAt(text, at).find_first_not_of(kSpace);
  std::vector<std::string_view> lines;
  while (at > 0) {
    at = lineBegin(text, at - 1);
    // In another column it continues the comment beside the line before.
    if (commentColumn(lineAt(text, at)) != column) {
      break;
    }
    lines.push_back(wordsOf(lineAt(text, at)));
  }
  std::string comment;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    append(comment, *line);
  }
  return comment;
}

std::string commentBeside(std::string_view text, size_t end) {
  size_t at = lineBegin(text, end);
  const std::string_view rest = lineAt(text, end);
  const size_t sign = rest.find_first_not_of(kSpace);
  if (sign == std::string_view::npos || rest[sign] != '#') {
    return "";
  }
  const size_t column = end + sign - at;
  std::string comment(wordsOf(rest));
  for (at += lineAt(text, at).size() + 1; at < text.size(); at += lineAt(text, at).size() + 1) {
    if (column == 0 || commentColumn(lineAt(text, at)) != column) {
      break;
    }
    append(comment, wordsOf(lineAt(text, at)));
  }
  return comment;
}

std::string commentAtHead(std::string_view text) {
  std::string comment;
  for (size_t at = 0; at < text.size(); at += lineAt(text, at).size() + 1) {
    const std::string_view line = lineAt(text, at);
    if (!trimmed(line).empty() && commentColumn(line) == std::string_view::npos) {
      break;
    }
    append(comment, wordsOf(line));
  }
  return comment;
}

}  // namespace glider::analysis
