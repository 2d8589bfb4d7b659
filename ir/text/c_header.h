// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/c_symbols.h"

#include <string>
#include <string_view>

namespace glider::ir {

/// The header against which the C and C++ of mission `name` is compiled: a prototype for all that
/// `in_c` has, each bound to the symbol that spells its types, and what its numbers mean.
std::string printHeader(const CInterface& in_c, std::string_view name);

}  // namespace glider::ir
