// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// The bounds in which two versions of a mission differ: when it has ended, how deep it goes, how
/// many states wait on its call stack.
std::vector<std::string> compareBounds(const compiler::Checked& before,
                                       const compiler::Checked& after);

}  // namespace glider::analysis
