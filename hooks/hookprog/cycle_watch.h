// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks {

/// Checks whether a report of the flight controller is from a later cycle than those before it. A
/// report from an earlier cycle is a repetition; two in order show that the vehicle has restarted
/// its count.
class CycleWatch {
 public:
  /// `cycle` wraps at 2^24.
  bool isNext(uint32_t cycle);

 private:
  uint32_t newest_ = 0;
  uint32_t earlier_ = 0;  ///< of the newest report, when `was_earlier_`
  bool known_ = false;
  bool was_earlier_ = false;
};

}  // namespace glider::hooks
