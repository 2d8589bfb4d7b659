// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/one_line.h"

#include <algorithm>

namespace glider::support {
namespace {

/// The length of the comment at the beginning of `text`; 0: there is none. An open one is long.
size_t commentIn(std::string_view text) {
  if (text.starts_with('#') || text.starts_with("//")) {
    return std::min(text.find('\n'), text.size());
  }
  constexpr std::string_view kEnd = "*/";
  if (!text.starts_with("/*")) {
    return 0;
  }
  const size_t end = text.find(kEnd, kEnd.size());
  return end == std::string_view::npos ? text.size() : end + kEnd.size();
}

bool isBlank(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

}  // namespace

std::string onOneLine(std::string_view text) {
  std::string out;
  bool quoted = false;
  for (size_t i = 0; i < text.size();) {
    const size_t comment = quoted ? 0 : commentIn(text.substr(i));
    quoted ^= text[i] == '"' && comment == 0;
    if (comment == 0 && !isBlank(text[i])) {
      out += text[i];
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
    i += std::max<size_t>(comment, 1);
  }
  return printable(out);
}

std::string conditionOnOneLine(std::string_view text) {
  std::string line = onOneLine(text);
  return line == "true" ? "without a condition" : line;
}

std::string printable(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return c == '\t' ? ' ' : (byte < 0x20 || byte == 0x7F) ? '?' : c;
  });
  return out;
}

}  // namespace glider::support
