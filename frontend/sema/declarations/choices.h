// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Checks the lines `choose` and `prefer`. The values that are chosen are constants of `scope`
/// already.
LeftOpen checkChoices(const ast::File& mission, Scope& scope);

}  // namespace glider::frontend
