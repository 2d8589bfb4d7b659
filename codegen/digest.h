// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace glider::codegen {

/// The SHA-256 of a text (FIPS 180-4), 64 hexadecimal digits. It is declared here because LLVM
/// implements it.
std::string digestOf(std::string_view text);

}  // namespace glider::codegen
