// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/scope.h"

#include <functional>
#include <vector>

namespace glider::frontend {

/// Reports `39,175 N` among arguments that are too many, each with its decimal point, if the
/// arguments `fit` with all of these read as one number each. False if they do not.
bool refuseDecimalCommas(const std::vector<ast::Argument>& arguments, Scope& scope,
                         const std::function<bool(const std::vector<ast::Argument>&)>& fit);

}  // namespace glider::frontend
