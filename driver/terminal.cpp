// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/terminal.h"

#include "driver/exit_code.h"
#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/render.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace glider::driver {
namespace {

bool colourWanted() {
  return ::isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
}

/// Where `tell` writes instead of standard error; null: nowhere else.
std::string* kept = nullptr;

}  // namespace

KeptMessages::KeptMessages() {
  kept = &text_;
}

KeptMessages::~KeptMessages() {
  kept = nullptr;
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
  const auto& row = support::catalogueRow(failure.id);
  tell(fmt::format("glidercc: error: {} [{} {}]\n", failure.message, support::code(failure.id),
                   row.slug));
  if (!failure.hint.empty()) {
    tell(fmt::format("  hint: {}\n", failure.hint));
  }
  return kWorldFailed;
}

void reportWarning(const support::Failure& warning) {
  const auto& row = support::catalogueRow(warning.id);
  tell(fmt::format("glidercc: warning: {} [{} {}]\n", warning.message, support::code(warning.id),
                   row.slug));
  if (!warning.hint.empty()) {
    tell(fmt::format("  hint: {}\n", warning.hint));
  }
}

void reportDiagnostics(const support::DiagnosticEngine& diagnostics,
                       const support::SourceManager& sources) {
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

ProgressLine::ProgressLine() : terminal_(::isatty(STDERR_FILENO) != 0) {}

void ProgressLine::show(std::string_view text) {
  if (terminal_) {
    tell(fmt::format("\r\x1b[K{}", text));
    shown_ = true;
  }
}

void ProgressLine::clear() {
  if (shown_) {
    tell("\r\x1b[K");
    shown_ = false;
  }
}

}  // namespace glider::driver
