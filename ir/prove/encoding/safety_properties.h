// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/horn.h"

namespace glider::ir::prove {

/// What a requirement asks of all runs: the run that it must not have. Of Reach the run that it
/// must have. Not for StackAtMost, which the structure answers.
SafetyProperty safetyPropertyFor(const Requirement& requirement, z3::context& context,
                                 const ProofContext& proof_context);

/// Whether the answer depends on how deep the vehicle is.
bool reckonsWithDepth(const Requirement& requirement, const ProofContext& proof_context);

}  // namespace glider::ir::prove
