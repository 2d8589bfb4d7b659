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
    const size_t space = text.substr(0, fits + 1).rfind(' ');
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
