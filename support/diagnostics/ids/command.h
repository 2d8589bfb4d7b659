// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/id.h"

/// The diagnostics of command.def.
namespace glider::support::diagnostics {

#define DIAGNOSTIC(number, name, ...) inline constexpr DiagnosticId name{number};
#include "support/diagnostics/command.def"
#undef DIAGNOSTIC

}  // namespace glider::support::diagnostics
