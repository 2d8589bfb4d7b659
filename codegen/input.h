// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/c_symbols.h"
#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>

namespace glider::codegen {

/// What code is generated for: a mission without errors, and what is known of it that a back end
/// needs. Refers to all of it, which must outlive it.
struct Input {
  const ir::Mission& mission;           ///< as it is built and flown
  const platforms::Platform& platform;  ///< that the mission is for; has all required roles
  uint32_t stack_depth = 0;             ///< greatest number of frames on the call stack
  /// As it was written, before any pass, with its requirements; null: `mission` is all there is.
  const ir::Mission* written = nullptr;
  /// All that it declares in C, used or not; null: what `mission` uses is all.
  const ir::CInterface* in_c = nullptr;
};

}  // namespace glider::codegen
