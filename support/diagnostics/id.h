// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace glider::support {

/// A diagnostic: its number in the catalogue. Their names are constants in ids/, a header for each
/// file of the catalogue: a new diagnostic compiles those again that report some of its kind.
enum class DiagnosticId : uint16_t {};

}  // namespace glider::support
