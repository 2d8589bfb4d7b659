// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_files/data_file.h"

#include <expected>
#include <string>
#include <string_view>

namespace glider::slocum {

/// Returns the lines of the text that a data file begins with, one by one.
class TextLines {
 public:
  TextLines(std::string_view content, size_t begin)
      : content_(content), line_begin_(begin), position_(begin) {}

  /// The next line, without its end. A byte outside ASCII is replaced by `?`. What is not a line
  /// of text, or ends without a line feed, is damage.
  std::expected<std::string, Damage> next();
  [[nodiscard]] size_t lineBegin() const { return line_begin_; }
  [[nodiscard]] size_t position() const { return position_; }

 private:
  std::string_view content_;
  size_t line_begin_;
  size_t position_;
};

}  // namespace glider::slocum
