// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace glider::compiler {

/// The linker's digest of the running program (NT_GNU_BUILD_ID), as its bytes; empty if it has
/// none.
std::string buildId();

}  // namespace glider::compiler
