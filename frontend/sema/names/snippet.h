// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::frontend {

/// An expression outside its mission: operands are numbered from its own start, the last node is
/// the root.
using Snippet = std::vector<ir::Expr>;

/// A copy of the expression `root`.
Snippet copy(const ir::Mission& mission, ir::ExprId root);
/// Appends the snippet to the mission's expressions; returns its root.
ir::ExprId paste(const Snippet& snippet, ir::Mission& mission);

}  // namespace glider::frontend
