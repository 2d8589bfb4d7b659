// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/horn.h"

namespace glider::ir::prove {

/// What a requirement asks of all runs: the run that it must not have. Of Reach the run that it
/// must have. Not for StackAtMost, which the structure answers.
Watch watchFor(const Requirement& requirement, z3::context& context, const Ground& ground);

/// Whether the answer depends on how deep the vehicle is.
bool reckonsWithDepth(const Requirement& requirement, const Ground& ground);

}  // namespace glider::ir::prove
