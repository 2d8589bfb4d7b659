// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "support/result.h"

#include <string>

namespace glider::driver {

/// For CLI11: what is wrong with `text` as a line and a column from 1, `7:12`; empty: nothing.
std::string checkPlace(const std::string& text);

/// The names of what was compiled as JSON, for editors, whether or not it has errors. With `place`,
/// which checkPlace takes: what stands there in the mission, and what can be named there.
support::Result<std::string> printSymbols(const compiler::Compilation& compilation,
                                          const std::string& place);

}  // namespace glider::driver
