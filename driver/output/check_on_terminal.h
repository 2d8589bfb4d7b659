// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/check/check.h"

#include <string>

namespace glider::driver {

using analysis::CheckedFile;
using analysis::CheckOptions;

/// analysis::checkMission with its progress on the last line of the terminal; errors in a scenario
/// are printed.
CheckedFile checkOnTerminal(const std::string& path, const CheckOptions& options);
/// The same for a mission that is compiled already.
CheckedFile checkOnTerminal(const std::string& name, compiler::Compilation compiled,
                            const CheckOptions& options);

}  // namespace glider::driver
