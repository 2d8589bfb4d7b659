// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::frontend {

/// An expression outside its mission: operands count from its own start, the last node is the
/// whole.
using Snippet = std::vector<ir::Expr>;

/// A copy of the expression `root`.
Snippet copy(const ir::Mission& mission, ir::ExprId root);
/// Puts the snippet at the end of the mission's expressions; gives its root.
ir::ExprId paste(const Snippet& snippet, ir::Mission& mission);

}  // namespace glider::frontend
