// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/result.h"
#include "support/source_manager.h"

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace glider::driver {

/// When messages are coloured. Auto: on a terminal, unless NO_COLOR is set.
enum class Colours : unsigned char { Auto, Always, Never };
void setColours(Colours when);

/// From now on progress and success are not reported: --quiet.
void setQuiet();

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

/// A diagnostic or failure that was reported.
struct Reported {
  support::Severity severity;
  support::DiagnosticId id;
  std::string message, hint;
  std::string file;  ///< empty: it has no place
  support::LineColumn begin, end;
};
/// While this exists, diagnostics and failures are kept; only failures are printed too.
class KeptReports {
 public:
  KeptReports();
  KeptReports(const KeptReports&) = delete;
  KeptReports& operator=(const KeptReports&) = delete;
  ~KeptReports();
  [[nodiscard]] const std::vector<Reported>& all() const { return all_; }

 private:
  std::vector<Reported> all_;
};

/// Prints an I/O or system error as `glidercc: error: … [GL9001 slug]` with its hint; returns its
/// exit code. If the reader of standard output has closed it (`| head`), it prints nothing and
/// returns the code of a program that SIGPIPE ends.
int reportFailure(const support::Failure& failure);
/// Prints a warning about files that could be read.
void reportWarning(const support::Failure& warning);
/// Prints the diagnostics to standard error, in the colours that setColours chose.
void reportDiagnostics(const support::DiagnosticEngine& diagnostics,
                       const support::SourceManager& sources);
/// Writes `text` to standard output. GL9002 when that fails (a full disk, a closed pipe).
support::Result<void> printOut(std::string_view text);
/// The same for what only says that all went well: nothing with --quiet.
support::Result<void> printSuccess(std::string_view text);

/// A progress line that is overwritten in place if standard error is a terminal. Elsewhere, in a
/// file or a pipe, a line is added every `between`. Nothing with --quiet.
class ProgressLine {
 public:
  explicit ProgressLine(std::chrono::milliseconds between = std::chrono::minutes(1));
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { clear(); }
  /// Whether it is overwritten in place.
  [[nodiscard]] bool onTerminal() const { return terminal_; }
  void show(std::string_view text);
  void clear();

 private:
  bool terminal_;
  bool shown_ = false;
  std::chrono::milliseconds between_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace glider::driver
