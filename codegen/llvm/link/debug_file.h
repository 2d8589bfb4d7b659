// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace glider::codegen {

/// An executable as it goes on board, and what a debugger wants besides.
struct SplitExecutable {
  std::string stripped;  ///< names its debug file in .gnu_debuglink
  std::string debug;     ///< symbols and line tables only
};

/// Splits the linked ELF file `linked`; `debug_name` is the file name under which the debug part
/// will lie beside the executable.
SplitExecutable splitDebug(std::string_view linked, const std::string& debug_name);

}  // namespace glider::codegen
