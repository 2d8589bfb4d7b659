// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>
#include <vector>

namespace glider::ir {

/// Something that no valid mission has, and where (nowhere for a sensor or behaviour).
struct Defect {
  support::SourceRange range;
  std::string message;
};

/// Whether `mission` holds together: every id in range, operands before their users, types as
/// `resultType` wants them, numbers that are numbers, names by which its text form can tell things
/// apart, at least one state, exactly one profile and one route a state. Empty if so. Stages that
/// take a mission CHECK this; the reader of the text form reports it.
std::vector<Defect> validate(const Mission& mission);

}  // namespace glider::ir
