// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>
#include <vector>

namespace glider::ir {

/// A property that no valid mission has, and where (an empty range for a sensor or behaviour).
struct Defect {
  support::SourceRange range;
  std::string message;
};

/// Checks that `mission` is consistent: every id in range, operands before their users, types as
/// `resultType` requires, numbers that are numbers, names that its text form can distinguish, at
/// least one state, exactly one profile and one route in each state. Empty if so. Stages that take
/// a mission CHECK this; the reader of the text form reports it.
std::vector<Defect> validate(const Mission& mission);

}  // namespace glider::ir
