// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/c_symbols.h"
#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>

namespace glider::codegen {

/// The input of code generation: a mission without errors, and what a back end needs to know about
/// it. Refers to all of it, which must outlive it.
struct Input {
  const ir::Mission& mission;           ///< as it is built and flown
  const platforms::Platform& platform;  ///< that the mission is for
  uint32_t stack_depth = 0;             ///< greatest number of frames on the call stack
  /// The mission as written, before any pass, with its requirements; null: there is only `mission`.
  const ir::Mission* written = nullptr;
  /// Everything that it declares in C, used or not; null: only what `mission` uses.
  const ir::CInterface* in_c = nullptr;
};

}  // namespace glider::codegen
