// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Evaluates the ranges of a signature's parameters, which must be known before the mission runs.
/// The signature is not valid, and that is reported, if one is not a range of its type.
void settleRanges(Signature& signature, Scope& scope);

}  // namespace glider::frontend
