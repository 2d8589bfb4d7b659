// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"

#include <fmt/format.h>

#include <expected>
#include <string>
#include <utility>

namespace glider::support {

/// An I/O or system error: of a file, a port, a tool. `id` is a row of the catalogue (mostly
/// GL9xxx).
struct Failure {
  DiagnosticId id;
  std::string message;
  std::string hint;
};

/// The result of a function that uses files, ports or tools.
template <typename T>
using Result = std::expected<T, Failure>;

/// The failure of row `id`, its message and hint filled with `args`.
template <typename... Args>
[[nodiscard]] std::unexpected<Failure> fail(DiagnosticId id, Args&&... args) {
  const CatalogueRow& row = catalogueRow(id);
  return std::unexpected(Failure{id, fmt::format(fmt::runtime(row.message), args...),
                                 fmt::format(fmt::runtime(row.hint), args...)});
}

}  // namespace glider::support
