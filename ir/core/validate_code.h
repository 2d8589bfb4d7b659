// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/defects.h"

namespace glider::ir {

/// The part of `validate` that checks the code of a mission: variables, temporals, blocks, cases
/// and states, given valid sensors, behaviours and expressions.
void validateCode(const Mission& mission, Defects& defects);

}  // namespace glider::ir
