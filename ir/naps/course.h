// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>

namespace glider::ir {

/// How a number goes on while no case does anything new.
enum class Course : uint8_t {
  Fixed,   ///< it stays
  Rises,   ///< by 1 a second
  Falls,   ///< by 1 a second
  Reading  ///< as the vehicle reports, or in another way that is not known
};

/// Of a number, or of the operands of a truth value: Fixed if all are.
Course courseOf(const Mission& mission, ExprId id);

}  // namespace glider::ir
