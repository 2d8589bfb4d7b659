// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/validate.h"

namespace glider::ir {

/// The part of `validate` that looks at what a mission does: variables, temporals, blocks, cases
/// and states, given sound sensors, behaviours and expressions.
void validateCode(const Mission& mission, std::vector<Defect>& defects);

}  // namespace glider::ir
