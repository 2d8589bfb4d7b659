// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/source_manager.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::slocum {

/// A part of one line with its location in the file.
struct Piece {
  std::string_view text;
  support::SourceRange range;

  [[nodiscard]] bool empty() const { return text.empty(); }
};

/// "'x'" in backquotes for a message: shortened, with unprintable bytes replaced.
std::string quoted(std::string_view text);
std::string lowerCase(std::string_view text);

/// Returns the lines of a mission file one by one: without comments, trimmed, without empty lines
/// and CR.
class LineReader {
 public:
  LineReader(const support::SourceManager& sources, uint32_t file,
             support::DiagnosticEngine& diagnostics);

  /// Reports GL5109 and returns false for a file that is not text or is too large to be a mission.
  bool acceptable();
  /// The next line with content; empty at the end.
  std::optional<Piece> next();
  /// Splits at spaces and tabs.
  [[nodiscard]] std::vector<Piece> words(Piece line) const;
  /// Reads `name(unit) value`; otherwise reports the error and returns nothing.
  std::optional<Setting> setting(Piece rest);
  /// A finite decimal number in `piece`; reports GL5102 and returns nothing if it is not one.
  std::optional<double> number(Piece piece);
  [[nodiscard]] Piece trimmed(size_t begin, size_t end) const;

 private:
  const std::string& text_;
  uint32_t file_;
  support::DiagnosticEngine& diagnostics_;
  size_t position_ = 0;
};

}  // namespace glider::slocum
