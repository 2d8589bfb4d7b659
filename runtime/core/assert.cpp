// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/assert.h"

namespace glider::runtime {

/// Out of line, so that each check costs a comparison and a call.
__attribute__((cold, noinline)) void noteFailedCheck(const GliderContext& context, Check check) {
  constexpr uint32_t kOne = 256;
  const uint32_t before = context.failed_checks;
  const_cast<GliderContext&>(context).failed_checks =
      (before != 0 ? before : static_cast<uint32_t>(check)) + kOne;
}

}  // namespace glider::runtime
