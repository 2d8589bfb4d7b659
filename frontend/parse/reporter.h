// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "support/diagnostics/engine.h"

#include <utility>

namespace glider::frontend {

/// Reports the errors in one file's text, and knows when there are so many that reading further is
/// of no use.
class SyntaxReporter {
 public:
  static constexpr size_t kMostMistakes = 100;

  SyntaxReporter(Source source, support::DiagnosticEngine& diagnostics)
      : source_(source), diagnostics_(diagnostics), before_(diagnostics.errorCount()) {}

  template <typename... Args>
  support::DiagnosticBuilder at(const Lexeme& lexeme, support::DiagnosticId id, Args&&... args) {
    return diagnostics_.report(id, source_.range(lexeme), std::forward<Args>(args)...);
  }

  [[nodiscard]] const Source& source() const { return source_; }
  [[nodiscard]] bool full() const { return count() >= kMostMistakes; }
  [[nodiscard]] size_t count() const { return diagnostics_.errorCount() - before_; }

 private:
  Source source_;
  support::DiagnosticEngine& diagnostics_;
  size_t before_;
};

}  // namespace glider::frontend
