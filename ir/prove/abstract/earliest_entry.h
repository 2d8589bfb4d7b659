// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <vector>

namespace glider::ir::prove {

/// The earliest mission time, s, at which any trace ends by `exit`; infinite: none does. From the
/// clocks alone, as earliestEntries.
double earliestExit(const ProofContext& proof_context);

/// For every state, the earliest mission time, s, at which any trace can enter it; infinite: no
/// trace enters it. From the clocks alone, for any values of sensors and variables.
std::vector<double> earliestEntries(const ProofContext& proof_context);

}  // namespace glider::ir::prove
