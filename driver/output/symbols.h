// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "support/result.h"

#include <string>

namespace glider::driver {

/// For CLI11: what is wrong with `text` as a line and a column from 1, such as `7:12`; empty if it
/// is valid.
std::string checkPlace(const std::string& text);

/// The names of what was compiled as JSON, for editors, whether or not it has errors. With `place`,
/// in the form that checkPlace accepts: the name at that place of the mission, and the names that
/// can be used there.
support::Result<std::string> printSymbols(const compiler::Compilation& compilation,
                                          const std::string& place);

}  // namespace glider::driver
