// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/outline.h"

#include <cstdint>
#include <optional>

namespace glider::frontend {

/// What a name right after token type `keyword`, which stands after `before`, is of.
std::optional<Naming> namingAfter(uint32_t keyword, uint32_t before);

/// What token type `t` between `before` and `next` names in an expression or statement; none: it is
/// not a name there.
std::optional<Naming> valueNaming(uint32_t before, uint32_t t, uint32_t next);

}  // namespace glider::frontend
