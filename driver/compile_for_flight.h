// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"

#include <memory>
#include <string>

namespace glider::driver {

/// Compiles `mission`, or that of a port's folder, as it is to be flown and shows its diagnostics;
/// null with `status` set when it has errors or cannot be read, or with `strict` if it has
/// warnings.
std::shared_ptr<const compiler::Optimised> compileForFlight(const std::string& mission, int& status,
                                                            bool strict = false);

/// Whether a warning is among them.
bool hasWarnings(const support::DiagnosticEngine& diagnostics);

}  // namespace glider::driver
