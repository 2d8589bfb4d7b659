// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/id.h"

#include <fmt/core.h>

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
[[nodiscard]] Failure failureOf(DiagnosticId id, fmt::format_args args);

/// The same as the error of a Result.
template <typename... Args>
[[nodiscard]] std::unexpected<Failure> fail(DiagnosticId id, const Args&... args) {
  return std::unexpected(failureOf(id, fmt::make_format_args(args...)));
}

}  // namespace glider::support
