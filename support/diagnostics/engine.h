// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"

#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

namespace glider::support {

/// Adds notes, a hint and fix-its to the diagnostic just reported. Valid until the next report.
class DiagnosticBuilder {
 public:
  explicit DiagnosticBuilder(Diagnostic& diagnostic) : diagnostic_(diagnostic) {}
  DiagnosticBuilder& note(SourceRange range, std::string message);
  /// Replaces the catalogue's hint (for a suggestion that depends on the place).
  DiagnosticBuilder& hint(std::string hint);
  DiagnosticBuilder& fix(SourceRange range, std::string replacement);

 private:
  Diagnostic& diagnostic_;
};

/// Collects the diagnostics of one compilation.
class DiagnosticEngine {
 public:
  /// Reports row `id` at `range`; `args` fill the row's message and hint in order.
  template <typename... Args>
  DiagnosticBuilder report(DiagnosticId id, SourceRange range, const Args&... args) {
    return reportFormatted(id, range, fmt::make_format_args(args...));
  }
  /// As the above, for a diagnostic that another stage or library has put together.
  DiagnosticBuilder add(Diagnostic diagnostic);

  [[nodiscard]] bool hasErrors() const { return errors_ > 0; }
  [[nodiscard]] size_t errorCount() const { return errors_; }
  /// Whether an error begins in `range`.
  [[nodiscard]] bool hasErrorIn(const SourceRange& range) const;
  [[nodiscard]] size_t warningCount() const { return warnings_; }
  /// All diagnostics sorted by file and position, exact duplicates dropped.
  [[nodiscard]] std::vector<Diagnostic> sorted() const;

 private:
  DiagnosticBuilder reportFormatted(DiagnosticId id, SourceRange range, fmt::format_args args);

  std::vector<Diagnostic> diagnostics_;
  size_t errors_ = 0;
  size_t warnings_ = 0;
};

}  // namespace glider::support
