// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::report {

namespace {

bool continuesCodePoint(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// The number of bytes of the first `columns` code points.
size_t bytesOf(std::string_view text, size_t columns) {
  size_t at = 0;
  for (size_t seen = 0; at < text.size(); ++at) {
    if (!continuesCodePoint(text[at]) && seen++ == columns) {
      break;
    }
  }
  return at;
}

/// The word that begins at `from`, without the punctuation after it.
std::string_view wordFrom(std::string_view text, size_t from) {
  const size_t end = std::min(text.find(' ', from), text.size());
  const std::string_view word = text.substr(from, end - from);
  return word.substr(0, word.find_last_not_of(",;:)") + 1);
}

/// The word that ends at `space`, without the bracket before it.
std::string_view wordBefore(std::string_view text, size_t space) {
  const size_t before = space == 0 ? std::string_view::npos : text.rfind(' ', space - 1);
  const size_t begin = before == std::string_view::npos ? 0 : before + 1;
  const std::string_view word = text.substr(begin, space - begin);
  return word.substr(std::min(word.find_first_not_of('('), word.size()));
}

bool isNumber(std::string_view word) {
  return !word.empty() && word.find_first_not_of("0123456789.") == std::string_view::npos;
}

bool isOneOf(std::string_view word, std::string_view letters) {
  return word.size() == 1 && letters.find(word[0]) != std::string_view::npos;
}

/// Whether the space is inside a position, which stays on one line: "39 10.498 N 73 49.821 W".
bool isInPosition(std::string_view text, size_t space) {
  const std::string_view before = wordBefore(text, space);
  const std::string_view after = wordFrom(text, space + 1);
  if (isNumber(before) && isOneOf(after, "NSEW")) {
    return true;
  }
  if (!isNumber(after)) {
    return false;
  }
  const size_t next = text.find(' ', space + 1);
  if (next == std::string_view::npos) {
    return false;
  }
  const std::string_view third = wordFrom(text, next + 1);
  if (isNumber(before)) {
    return isOneOf(third, "NSEW");  // degrees and minutes
  }
  const bool minutes = isNumber(third) && text.find(' ', next + 1) != std::string_view::npos;
  return isOneOf(before, "NS") &&
         (isOneOf(third, "EW") ||
          (minutes && isOneOf(wordFrom(text, text.find(' ', next + 1) + 1), "EW")));
}

/// The last space of `text` up to `most` at which a line may end.
size_t lineEnd(std::string_view text, size_t most) {
  size_t space = text.rfind(' ', most);
  while (space != std::string_view::npos && space > 0 && isInPosition(text, space)) {
    space = text.rfind(' ', space - 1);
  }
  return space;
}

}  // namespace

std::string plain(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F, which some terminals interpret like an escape, are C2 80 to C2 9F.
    const bool c1 = c == 0xC2U && i + 1 < text.size() &&
                    static_cast<unsigned char>(text[i + 1]) >= 0x80U &&
                    static_cast<unsigned char>(text[i + 1]) < 0xA0U;
    out += c < 0x20U || c == 0x7FU || c1 ? '?' : text[i];
    i += c1 ? 1 : 0;
  }
  return out;
}

size_t width(std::string_view text) {
  return static_cast<size_t>(
      std::ranges::count_if(text, [](char c) { return !continuesCodePoint(c); }));
}

std::string cut(std::string_view text, size_t columns) {
  if (width(text) <= columns) {
    return std::string(text);
  }
  return std::string(text.substr(0, bytesOf(text, columns - 1))) + "…";
}

std::string padded(std::string_view text, size_t columns) {
  const size_t used = width(text);
  return std::string(text) + std::string(used < columns ? columns - used : 0, ' ');
}

std::string wrapped(std::string_view text, size_t columns, size_t indent) {
  std::string out;
  size_t used = 0;
  while (width(text) > columns - used) {
    const size_t fits = bytesOf(text, columns - used);
    const size_t space = lineEnd(text, fits);
    const size_t word = text.find_first_not_of(' ');
    const bool at_space = space != std::string_view::npos && space > word;
    const size_t end = at_space ? space : fits;
    out += text.substr(0, end);
    out += '\n';
    text.remove_prefix(at_space ? end + 1 : end);
    out.append(indent, ' ');
    used = indent;
  }
  out += text;
  out += '\n';
  return out;
}

std::string clockText(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  const long long hours = whole / 3600;
  const long long minutes = whole / 60 % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                   : fmt::format("{}:{:02}", minutes, whole % 60);
}

}  // namespace glider::report
