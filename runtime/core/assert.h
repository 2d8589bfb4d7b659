// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"
#include "runtime/log/records.h"

/// Checks of the program's own memory, which no input can make fail: input is checked where it
/// arrives, and answered with an error. After a failed check the runtime answers no frame, and
/// hookbeh ends its control ("Checks of its own memory" of runtime/README.md).
namespace glider::runtime {

/// Counts a failed check in `context`, and keeps the number of the first. The context is only noted
/// in, also where its owner may only read it: no context is a constant.
void noteFailedCheck(const GliderContext& context, Check check);

/// Check number `index` after `first`; Check::None if the index is `count`.
constexpr Check firstOf(Check first, uint32_t index, uint32_t count) {
  return index == count ? Check::None : static_cast<Check>(static_cast<uint32_t>(first) + index);
}

/// The number of the first failed check; 0: none.
inline uint32_t firstFailedCheck(const GliderContext& context) {
  return context.failed_checks & 0xFFU;
}
/// How many checks failed.
inline uint32_t countOfFailedChecks(const GliderContext& context) {
  return context.failed_checks >> 8U;
}

}  // namespace glider::runtime

/// Whether `condition` holds. If not, notes that `check` (a row of log/checks.def) failed; the
/// caller must then return without using what it checked.
#define GLIDER_ASSERT(context, condition, check) \
  ((condition) ||                                \
   (glider::runtime::noteFailedCheck((context), glider::runtime::Check::check), false))
