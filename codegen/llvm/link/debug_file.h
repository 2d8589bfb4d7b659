// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace glider::codegen {

/// An executable as it goes on board, and a separate file for debuggers.
struct SplitExecutable {
  std::string stripped;  ///< contains the name of its debug file in .gnu_debuglink
  std::string debug;     ///< symbols and line tables only
};

/// Splits the linked ELF file `linked`; `debug_name` is the file name that the debug part will have
/// beside the executable.
SplitExecutable splitDebug(std::string_view linked, const std::string& debug_name);

}  // namespace glider::codegen
