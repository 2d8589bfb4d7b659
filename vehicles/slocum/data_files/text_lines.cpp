// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_files/text_lines.h"

namespace glider::slocum {
namespace {

constexpr size_t kLongestLine = 1000;  // real ones are below 100

}  // namespace

std::expected<std::string, Damage> TextLines::next() {
  line_begin_ = position_;
  const std::string_view rest = content_.substr(position_, kLongestLine);
  const size_t end = rest.find('\n');
  const std::string_view raw = rest.substr(0, end);
  std::string line;
  for (const char c : raw.substr(0, raw.size() - (raw.ends_with('\r') ? 1U : 0U))) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' && byte != '\t') {
      return std::unexpected(Damage{line_begin_ + line.size(), "expected text"});
    }
    line += byte < 0x7f ? c : '?';
  }
  if (end == std::string_view::npos) {
    const bool cut = rest.size() < kLongestLine;
    return std::unexpected(
        Damage{cut ? content_.size() : line_begin_,
               cut ? "the file ends within a line of text" : "a line of text does not end"});
  }
  position_ += end + 1;
  return line;
}

}  // namespace glider::slocum
