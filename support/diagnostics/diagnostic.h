// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/id.h"
#include "support/source_range.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glider::support {

enum class Severity : uint8_t { Note, Warning, Error };

/// "note", "warning", "error".
std::string_view word(Severity severity);

/// One row of the catalogue.
struct CatalogueRow {
  DiagnosticId id;
  std::string_view name;
  std::string_view slug;
  Severity severity;
  std::string_view message;
  std::string_view hint;
};

/// The whole catalogue, in the order of the .def files.
const std::vector<CatalogueRow>& catalogue();
/// The row of `id`; every id has one.
const CatalogueRow& catalogueRow(DiagnosticId id);
/// "GL2003".
std::string code(DiagnosticId id);

/// A replacement that `glidercc fix` may apply.
struct FixIt {
  SourceRange range;
  std::string replacement;
};

struct DiagnosticNote {
  SourceRange range;
  std::string message;
};

struct Diagnostic {
  DiagnosticId id;
  Severity severity;
  SourceRange range;
  std::string message;
  std::string hint;
  std::vector<DiagnosticNote> notes;
  std::vector<FixIt> fixes;
};

}  // namespace glider::support
