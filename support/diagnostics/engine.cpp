// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace glider::support {

DiagnosticBuilder& DiagnosticBuilder::note(SourceRange range, std::string message) {
  diagnostic_.notes.push_back({range, std::move(message)});
  return *this;
}

DiagnosticBuilder& DiagnosticBuilder::hint(std::string hint) {
  diagnostic_.hint = std::move(hint);
  return *this;
}

DiagnosticBuilder& DiagnosticBuilder::fix(SourceRange range, std::string replacement) {
  diagnostic_.fixes.push_back({range, std::move(replacement)});
  return *this;
}

DiagnosticBuilder DiagnosticEngine::reportFormatted(DiagnosticId id, SourceRange range,
                                                    fmt::format_args args) {
  const CatalogueRow& row = catalogueRow(id);
  return add({id,
              row.severity,
              range,
              fmt::vformat(row.message, args),
              fmt::vformat(row.hint, args),
              {},
              {}});
}

DiagnosticBuilder DiagnosticEngine::add(Diagnostic diagnostic) {
  errors_ += diagnostic.severity == Severity::Error ? 1 : 0;
  warnings_ += diagnostic.severity == Severity::Warning ? 1 : 0;
  diagnostics_.push_back(std::move(diagnostic));
  return DiagnosticBuilder(diagnostics_.back());
}

bool DiagnosticEngine::hasErrorIn(const SourceRange& range) const {
  return errors_ > 0 && std::ranges::any_of(diagnostics_, [&](const Diagnostic& one) {
           return one.severity == Severity::Error && one.range.file == range.file &&
                  one.range.begin >= range.begin && one.range.begin < range.end;
         });
}

std::vector<Diagnostic> DiagnosticEngine::sorted() const {
  auto key = [](const Diagnostic& d) {
    return std::tuple(d.range.file, d.range.begin, d.range.end, d.id, std::string_view(d.message));
  };
  std::vector<Diagnostic> result = diagnostics_;
  std::ranges::stable_sort(result, {}, key);
  auto same = [&](const Diagnostic& a, const Diagnostic& b) { return key(a) == key(b); };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

}  // namespace glider::support
