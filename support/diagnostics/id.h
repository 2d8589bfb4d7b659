// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace glider::support {

/// The name of a diagnostic. Its enumerators are in catalogue.h, which only the sources include
/// that report one: a new diagnostic then compiles those again, not the whole tree.
enum class DiagnosticId : uint16_t;

}  // namespace glider::support
