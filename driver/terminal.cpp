// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/terminal.h"

#include "driver/exit_code.h"
#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>
#include <utility>

namespace glider::driver {
namespace {

Colours colours = Colours::Auto;
bool quiet = false;

bool colourWanted() {
  return colours == Colours::Auto
             ? ::isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr
             : colours == Colours::Always;
}

/// Standard output was closed at its other end, which is how `| head` ends a program.
support::Failure closedPipe() {
  return support::fail(support::diagnostics::cannotWrite, "standard output", std::strerror(EPIPE))
      .error();
}

/// Where `tell` writes instead of standard error; null: nowhere else.
std::string* kept = nullptr;

/// Where reports are kept; null: nowhere.
std::vector<Reported>* reports = nullptr;

void keep(support::Severity severity, const support::Failure& failure) {
  if (reports != nullptr) {
    reports->push_back({severity, failure.id, failure.message, failure.hint, "", {}, {}});
  }
}

void keepAll(const support::DiagnosticEngine& diagnostics, const support::SourceManager& sources) {
  for (const support::Diagnostic& one : diagnostics.sorted()) {
    Reported reported{one.severity, one.id, one.message, one.hint, "", {}, {}};
    if (one.range.valid()) {
      reported.file = sources.name(one.range.file);
      reported.begin = sources.place(one.range.file, one.range.begin);
      reported.end = sources.place(one.range.file, std::max(one.range.begin, one.range.end));
    }
    reports->push_back(std::move(reported));
  }
}

}  // namespace

void setColours(Colours when) {
  colours = when;
}

void setQuiet() {
  quiet = true;
}

KeptMessages::KeptMessages() {
  kept = &text_;
}

KeptMessages::~KeptMessages() {
  kept = nullptr;
}

KeptReports::KeptReports() {
  reports = &all_;
}

KeptReports::~KeptReports() {
  reports = nullptr;
}

void tell(std::string_view text) {
  if (kept != nullptr) {
    *kept += text;
    return;
  }
  // Not fmt::print, which throws when the write fails: such a failure must only show in the exit
  // code.
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
  (void)std::fflush(stderr);
}

int reportFailure(const support::Failure& failure) {
  if (failure.message == closedPipe().message) {
    return kInterrupted + SIGPIPE;
  }
  keep(support::Severity::Error, failure);
  const auto& row = support::catalogueRow(failure.id);
  tell(fmt::format("glidercc: error: {} [{} {}]\n", failure.message, support::code(failure.id),
                   row.slug));
  if (!failure.hint.empty()) {
    tell(fmt::format("  hint: {}\n", failure.hint));
  }
  return kWorldFailed;
}

void reportWarning(const support::Failure& warning) {
  if (reports != nullptr) {
    keep(support::Severity::Warning, warning);
    return;
  }
  const auto& row = support::catalogueRow(warning.id);
  tell(fmt::format("glidercc: warning: {} [{} {}]\n", warning.message, support::code(warning.id),
                   row.slug));
  if (!warning.hint.empty()) {
    tell(fmt::format("  hint: {}\n", warning.hint));
  }
}

void reportDiagnostics(const support::DiagnosticEngine& diagnostics,
                       const support::SourceManager& sources) {
  if (reports != nullptr) {
    keepAll(diagnostics, sources);
    return;
  }
  tell(support::render(diagnostics, sources, colourWanted()));
}

support::Result<void> printOut(std::string_view text) {
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) {
    return support::fail(support::diagnostics::cannotWrite, "standard output",
                         std::strerror(errno));
  }
  return {};
}

support::Result<void> printSuccess(std::string_view text) {
  return quiet ? support::Result<void>{} : printOut(text);
}

ProgressLine::ProgressLine(std::chrono::milliseconds between)
    : terminal_(::isatty(STDERR_FILENO) != 0), between_(between) {}

void ProgressLine::show(std::string_view text) {
  if (quiet) {
    return;
  }
  if (terminal_) {
    tell(fmt::format("\r\x1b[K{}", text));
    shown_ = true;
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ >= between_) {
    tell(fmt::format("glidercc: {}\n", text));
    last_ = now;
  }
}

void ProgressLine::clear() {
  if (shown_) {
    tell("\r\x1b[K");
    shown_ = false;
  }
}

}  // namespace glider::driver
