// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/result.h"
#include "support/source_manager.h"

#include <string>
#include <string_view>

namespace glider::driver {

/// Writes to standard error; a failed write is ignored, since standard error may be closed.
void tell(std::string_view text);
/// While this exists, `tell` keeps what it would write.
class KeptMessages {
 public:
  KeptMessages();
  KeptMessages(const KeptMessages&) = delete;
  KeptMessages& operator=(const KeptMessages&) = delete;
  ~KeptMessages();
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Prints an I/O or system error as `glidercc: error: … [GL9001 slug]` with its hint; returns its
/// exit code.
int reportFailure(const support::Failure& failure);
/// Prints a warning about files that could be read.
void reportWarning(const support::Failure& warning);
/// Prints the diagnostics to standard error, in colour on a terminal (unless NO_COLOR is set).
void reportDiagnostics(const support::DiagnosticEngine& diagnostics,
                       const support::SourceManager& sources);
/// Writes `text` to standard output. GL9002 when that fails (a full disk, a closed pipe).
support::Result<void> printOut(std::string_view text);

/// A progress line that is overwritten in place; shown only if standard error is a terminal.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { clear(); }
  /// Whether anything is shown.
  [[nodiscard]] bool onTerminal() const { return terminal_; }
  void show(std::string_view text);
  void clear();

 private:
  bool terminal_;
  bool shown_ = false;
};

}  // namespace glider::driver
