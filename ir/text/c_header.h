// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/c_symbols.h"

#include <string>
#include <string_view>

namespace glider::ir {

/// The header for the C and C++ code of mission `name`: a prototype for everything in `in_c`, each
/// bound to the symbol that contains its types, and the meaning of its numbers.
std::string printHeader(const CInterface& in_c, std::string_view name);

}  // namespace glider::ir
