// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/symbols.h"

#include <vector>

namespace glider::frontend {

/// The names that every mission for `platform` has: the platform, its sensors, the clocks,
/// conditions, functions and commands of the language.
std::vector<Symbol> builtIn(const platforms::Platform& platform);

}  // namespace glider::frontend
