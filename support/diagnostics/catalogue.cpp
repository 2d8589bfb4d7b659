// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/check.h"
#include "support/diagnostics/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::support {

const std::vector<CatalogueRow>& catalogue() {
  static const std::vector<CatalogueRow> rows = {
#define DIAGNOSTIC(number, name, slug, severity, message, hint) \
  {DiagnosticId{number}, #name, slug, Severity::severity, message, hint},
#include "support/diagnostics/catalogue.def"
#undef DIAGNOSTIC
  };
  return rows;
}

const CatalogueRow& catalogueRow(DiagnosticId id) {
  auto row = std::ranges::find(catalogue(), id, &CatalogueRow::id);
  CHECK(row != catalogue().end(), "a diagnostic without a row");
  return *row;
}

std::string code(DiagnosticId id) {
  return fmt::format("GL{:04}", static_cast<unsigned>(id));
}

std::string_view word(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "";
}

}  // namespace glider::support
