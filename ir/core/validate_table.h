// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>

namespace glider::ir {

/// What is wrong with the form of a table of guards for `case_count` cases; empty if nothing is.
/// Does not check that its rows agree with the guards.
std::string defectOf(const GuardTable& table, const Mission& mission, size_t case_count);

}  // namespace glider::ir
