// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/id.h"

namespace glider::support {

/// The diagnostics' names; the value is the number of the row in catalogue.def.
enum class DiagnosticId : uint16_t {
#define DIAGNOSTIC(number, name, slug, severity, message, hint) name = number,
#include "support/diagnostics/catalogue.def"
#undef DIAGNOSTIC
};

}  // namespace glider::support
