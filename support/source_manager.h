// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_range.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glider::support {

/// A place as an editor counts it: line and column from 1; a column counts Unicode code points.
struct LineColumn {
  uint32_t line = 1;
  uint32_t column = 1;
};

/// Owns the text of every file of one compilation.
class SourceManager {
 public:
  /// Takes a file's display name and text; returns the number for SourceRange::file.
  uint32_t add(std::string name, std::string text);

  /// How many files it has; their numbers are below.
  [[nodiscard]] uint32_t count() const { return static_cast<uint32_t>(files_.size()); }
  [[nodiscard]] const std::string& name(uint32_t file) const { return files_.at(file).name; }
  [[nodiscard]] const std::string& text(uint32_t file) const { return files_.at(file).text; }
  [[nodiscard]] std::string_view text(SourceRange range) const;
  /// The line and column of byte `offset` of `file`; past the end gives the last place.
  [[nodiscard]] LineColumn place(uint32_t file, uint32_t offset) const;
  /// Line `line` (from 1) of `file` without its line end.
  [[nodiscard]] std::string_view line(uint32_t file, uint32_t line) const;

 private:
  struct File {
    std::string name;
    std::string text;
    std::vector<uint32_t> line_starts;
  };
  std::vector<File> files_;
};

}  // namespace glider::support
