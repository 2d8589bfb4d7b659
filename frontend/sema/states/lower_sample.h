// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"
#include "ir/core/mission.h"

#include <vector>

namespace glider::frontend {

/// Lowers `sample …`, whose first word is at `keyword`, in the context of its state.
std::vector<ir::Sampling> lowerSample(const ast::SampleMember& node,
                                      const support::SourceRange& keyword, Scope& scope);

}  // namespace glider::frontend
