// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/result.h"

#include "support/diagnostics/diagnostic.h"

#include <fmt/format.h>

namespace glider::support {

Failure failureOf(DiagnosticId id, fmt::format_args args) {
  const CatalogueRow& row = catalogueRow(id);
  return {id, fmt::vformat(row.message, args), fmt::vformat(row.hint, args)};
}

}  // namespace glider::support
